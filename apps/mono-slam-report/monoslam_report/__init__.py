# SPDX-License-Identifier: BSD-3-Clause
"""Statistics over seeds, and the report of a batch."""
