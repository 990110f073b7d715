// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "ImageSource.h"

namespace monoslam
{
struct ConvertOptions
{
    SourceOptions source;
    std::string cameraFile;
    std::string truthFile;  ///< may be empty
    std::string output;
    bool embed = false;
    bool force = false;
};

/** \throw std::exception naming file and place */
void convert(const ConvertOptions& options);
}  // namespace monoslam
