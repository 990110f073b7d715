// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/containers/yaml.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace monoslam
{
/** A yaml map that remembers which keys were read. */
class YamlKeys
{
   public:
    YamlKeys(const mrpt::containers::yaml& root, std::string path)
        : root_(root), path_(std::move(path))
    {
    }

    [[nodiscard]] bool has(const std::string& key) const { return root_.has(key); }

    double number(const std::string& key)
    {
        asked_.insert(key);
        if (!root_.has(key)) fail("key " + key + " is missing");
        try
        {
            return root_[key].as<double>();
        }
        catch (const std::exception&)
        {
            fail("key " + key + " is not a number");
        }
    }

    double number(const std::string& key, double fallback)
    {
        return root_.has(key) ? number(key) : fallback;
    }

    std::vector<double> numbers(const std::string& key, std::size_t count)
    {
        asked_.insert(key);
        if (!root_.has(key)) fail("key " + key + " is missing");
        std::vector<double> values;
        try
        {
            for (const auto& item : root_[key].asSequence()) values.push_back(item.as<double>());
        }
        catch (const std::exception&)
        {
            fail("key " + key + " is not a list of numbers");
        }
        if (values.size() < count)
            fail("key " + key + " has fewer than " + std::to_string(count) + " numbers");
        return values;
    }

    std::string text(const std::string& key, const std::string& fallback)
    {
        asked_.insert(key);
        return root_.has(key) ? root_[key].as<std::string>() : fallback;
    }

    [[nodiscard]] mrpt::containers::yaml child(const std::string& key)
    {
        asked_.insert(key);
        return root_[key];
    }

    [[nodiscard]] std::vector<std::string> ignored() const
    {
        std::vector<std::string> keys;
        for (const auto& [key, value] : root_.asMap())
            if (const auto text = key.as<std::string>(); !asked_.count(text)) keys.push_back(text);
        return keys;
    }

   private:
    [[noreturn]] void fail(const std::string& message) const
    {
        throw std::invalid_argument(path_ + ": " + message);
    }

    const mrpt::containers::yaml& root_;
    std::string path_;
    std::set<std::string> asked_;
};
}  // namespace monoslam
