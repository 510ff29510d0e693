// SPDX-License-Identifier: MIT
#pragma once

// The only door to Vulkan: precompiled for this room, never included from a public header.
// The header is huge; what is switched off here is not used and halves its cost.
#define VULKAN_HPP_NO_CONSTRUCTORS
#define VULKAN_HPP_NO_SETTERS
#define VULKAN_HPP_NO_SPACESHIP_OPERATOR
#define VULKAN_HPP_NO_SMART_HANDLE
#include <fmt/format.h>

#include <vulkan/vulkan_raii.hpp>
