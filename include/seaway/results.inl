// SPDX-License-Identifier: MIT
// Every result code: SW_RESULT(name, text). Included by base.h for the enum and by result.c for the texts.
SW_RESULT(SUCCESS, "success")
SW_RESULT(ERROR_INVALID, "an argument is outside its range")
SW_RESULT(ERROR_NO_MEMORY, "the host's allocator returned no memory")
SW_RESULT(ERROR_LIMIT, "a fixed limit is reached")
SW_RESULT(ERROR_FILE, "a file could not be read or written")
SW_RESULT(ERROR_FORMAT, "data do not have the expected format")
SW_RESULT(ERROR_UNSUPPORTED, "this build or device lacks a needed feature")
SW_RESULT(ERROR_NO_DEVICE, "no usable Vulkan device was found")
SW_RESULT(ERROR_DEVICE_LOST, "the Vulkan device was lost")
SW_RESULT(ERROR_DEVICE, "a Vulkan call failed")
