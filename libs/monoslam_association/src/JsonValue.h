// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace monoslam
{
using Json = nlohmann::ordered_json;

/** A value of a JSON file that knows where it stands, for errors that say so. */
class JsonValue
{
   public:
    JsonValue(const Json& value, std::string where) : value_(&value), where_(std::move(where)) {}

    [[noreturn]] void fail(const std::string& message) const
    {
        throw std::invalid_argument(where_ + ": " + message);
    }

    /** Fails if there are other keys than these. */
    void expectKeys(const std::vector<std::string>& keys) const
    {
        if (!value_->is_object()) fail("is not a map of keys");
        for (const auto& entry : value_->items())
            if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
                fail("unknown key " + entry.key());
    }

    [[nodiscard]] JsonValue operator[](const std::string& key) const
    {
        if (!value_->is_object()) fail("is not a map of keys");
        if (!value_->contains(key)) fail("key " + key + " is missing");
        return {value_->at(key), where_ + ": " + key};
    }

    [[nodiscard]] bool isNull() const { return value_->is_null(); }

    [[nodiscard]] double number() const
    {
        if (!value_->is_number()) fail("is not a number");
        return value_->get<double>();
    }

    [[nodiscard]] std::int64_t whole() const
    {
        if (!value_->is_number_integer()) fail("is not a whole number");
        return value_->get<std::int64_t>();
    }

    [[nodiscard]] std::string text() const
    {
        if (!value_->is_string()) fail("is not a text");
        return value_->get<std::string>();
    }

    [[nodiscard]] std::vector<JsonValue> list() const
    {
        if (!value_->is_array()) fail("is not a list");
        std::vector<JsonValue> items;
        for (std::size_t i = 0; i < value_->size(); ++i)
            items.emplace_back((*value_)[i], where_ + "[" + std::to_string(i) + "]");
        return items;
    }

    /** \param size  to be had, -1 = any */
    [[nodiscard]] Eigen::VectorXd vector(Eigen::Index size = -1) const
    {
        if (!value_->is_array()) fail("is not a list of numbers");
        const auto count = static_cast<Eigen::Index>(value_->size());
        if (size >= 0 && count != size)
            fail("has " + std::to_string(count) + " numbers instead of " + std::to_string(size));
        Eigen::VectorXd numbers(count);
        for (Eigen::Index i = 0; i < count; ++i)
        {
            const Json& item = (*value_)[static_cast<std::size_t>(i)];
            if (!item.is_number()) fail("number " + std::to_string(i) + " of it is none");
            numbers(i) = item.get<double>();
        }
        return numbers;
    }

    /** A list of rows. */
    [[nodiscard]] Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index cols) const
    {
        const std::vector<JsonValue> items = list();
        if (static_cast<Eigen::Index>(items.size()) != rows)
            fail("has " + std::to_string(items.size()) + " rows instead of " +
                 std::to_string(rows));
        Eigen::MatrixXd numbers(rows, cols);
        for (std::size_t i = 0; i < items.size(); ++i)
            numbers.row(static_cast<Eigen::Index>(i)) = items[i].vector(cols).transpose();
        return numbers;
    }

   private:
    const Json* value_;
    std::string where_;
};

[[nodiscard]] inline Json numbersToJson(const Eigen::Ref<const Eigen::VectorXd>& numbers)
{
    if (!numbers.allFinite()) throw std::invalid_argument("a number to be written is not finite");
    return std::vector<double>(numbers.begin(), numbers.end());
}

/** A list of rows. */
[[nodiscard]] inline Json rowsToJson(const Eigen::Ref<const Eigen::MatrixXd>& numbers)
{
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < numbers.rows(); ++i)
        rows.push_back(numbersToJson(Eigen::VectorXd(numbers.row(i).transpose())));
    return rows;
}
}  // namespace monoslam
