# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with the input, in one line that names the file."""


class ReportError(Exception):
    pass
