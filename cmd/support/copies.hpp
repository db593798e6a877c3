// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Copies for recipients: the ledger that goes with a key, and a copy and its entry as one step.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <wm3d/io.hpp>
#include <wm3d/key/key_file.hpp>
#include <wm3d/ledger/ledger.hpp>

namespace wm3d::cmd {

/// The ledger that was named, or the key's file with the extension .ledger.
std::string ledger_path(const std::string& named, const std::string& key_file);

ledger::Owner owner_of(const key::Key& key);

/// \throw ParameterError  if it is empty, longer than 200 bytes or no line of UTF-8
void check_recipient(std::string_view name);

/// Finds out before any work whether a copy could be entered.
/// \throw ParameterError  if the work has one for this recipient, or the ledger is another key's
void check_entry(const std::string& ledger, const key::Key& key, std::string_view work,
                 std::string_view recipient);

/// Whether the ledger already tells how the copies of a work lie.
bool has_receipt(const std::string& ledger, std::string_view work);

/// The names of a model's files.
std::vector<std::filesystem::path> names_of(const std::filesystem::path& path, const io::PatchedFiles& files);

/// Gives the files of a copy, whose bytes are on the disk already, their names and enters it in the ledger:
/// both or neither. What they replace with `overwrite` comes back where the entry fails. The receipt is kept if the
/// work has none yet.
/// \throw OutputError, ParameterError
ledger::Entry enter_copy(const std::string& ledger, const key::Key& key, ledger::Entry entry,
                         std::string_view receipt, io::FileSet& files,
                         const std::vector<std::filesystem::path>& names, bool overwrite);

} // namespace wm3d::cmd
