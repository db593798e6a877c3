// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/core.hpp>

export module wm3d.core;

export namespace wm3d {
using wm3d::check_json_depth;
using wm3d::Descriptor;
using wm3d::Error;
using wm3d::ErrorCode;
using wm3d::file_into;
using wm3d::Filed;
using wm3d::filed;
using wm3d::Fnv;
using wm3d::folder_of;
using wm3d::from_base64;
using wm3d::from_hex;
using wm3d::GeometryError;
using wm3d::InputError;
using wm3d::is_printable;
using wm3d::is_utf8;
using wm3d::json_depth;
using wm3d::max_json_depth;
using wm3d::name;
using wm3d::notify;
using wm3d::OutputError;
using wm3d::parallel_blocks;
using wm3d::parallel_invoke;
using wm3d::parallel_shares;
using wm3d::parallel_sum;
using wm3d::parallel_sum_of;
using wm3d::parallel_tasks;
using wm3d::ParameterError;
using wm3d::Progress;
using wm3d::return_freed_memory;
using wm3d::split_mix;
using wm3d::split_mix_finalizer;
using wm3d::split_mix_step;
using wm3d::sync_folder_of;
using wm3d::thread_count;
using wm3d::ThreadLimit;
using wm3d::to_base64;
using wm3d::to_hex;
using wm3d::version;
using wm3d::whole_number;
using wm3d::write_all;
} // namespace wm3d
