// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace monoslam
{
/** The folder of a batch, ours as long as the object lives. */
class OutputFolder
{
   public:
    /** Creates the folder where there is none.
     *  \param force  also a folder that holds files and has not been a batch's
     *  \param patience  how long another batch in it may still take to end
     *  \throw std::runtime_error naming the folder, also while another batch runs in it */
    OutputFolder(const std::string& path, bool force,
                 std::chrono::milliseconds patience = std::chrono::seconds(5));
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

   private:
    int lock_;
};
}  // namespace monoslam
