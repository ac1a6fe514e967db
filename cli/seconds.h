// SPDX-License-Identifier: MIT
#pragma once

// Seconds of a clock that only goes forward.
double GetSeconds(void);
