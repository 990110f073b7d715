// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace monoslam
{
/** The folder of a batch, ours as long as the object lives. */
class OutputFolder
{
   public:
    /** Creates the folder where there is none.
     *  \param force  also a folder that holds files and has not been a batch's
     *  \throw std::runtime_error naming the folder, also while another batch runs in it */
    OutputFolder(const std::string& path, bool force);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

   private:
    int lock_;
};
}  // namespace monoslam
