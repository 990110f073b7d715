// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace monoslam
{
/** A CSV file with a header, read line by line; a quoted cell may hold commas. */
class CsvFile
{
   public:
    /** \throw std::invalid_argument if the file cannot be read */
    explicit CsvFile(const std::string& fileName);

    /** Goes to the next line. \return false at the end
     *  \throw std::invalid_argument naming file and line if it is cut short */
    bool next();

    /** Cell of the current line. \throw std::invalid_argument naming file, line and column */
    [[nodiscard]] const std::string& text(const std::string& column) const;
    [[nodiscard]] double number(const std::string& column) const;

   private:
    std::string fileName_;
    std::ifstream stream_;
    long line_ = 1;
    std::vector<std::string> header_;
    std::vector<std::string> cells_;
};
}  // namespace monoslam
