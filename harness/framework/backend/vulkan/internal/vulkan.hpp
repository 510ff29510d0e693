// SPDX-License-Identifier: MIT
#pragma once

// The only include of Vulkan: precompiled for this room, never included from a public header.
// The header is huge. The parts that are switched off here are not used; without them it costs half.
#define VULKAN_HPP_NO_CONSTRUCTORS
#define VULKAN_HPP_NO_SETTERS
#define VULKAN_HPP_NO_SPACESHIP_OPERATOR
#define VULKAN_HPP_NO_SMART_HANDLE
#include <fmt/format.h>

#include <vulkan/vulkan_raii.hpp>
