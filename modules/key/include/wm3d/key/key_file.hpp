// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The key file: secret and public parameters as a short readable text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <wm3d/key/passphrase.hpp>
#include <wm3d/key/secret.hpp>

namespace wm3d::key {

/// What marks made with a key have in common, so that `verify` needs nothing but the key file.
struct PublicParameters {
    std::vector<unsigned> levels{3, 4, 5, 6}; ///< subdivision levels that marks may use, ascending
    double rmax = 0.1;                        ///< height of the bumps, for a sphere of radius 1
    double reference_strength = 0.05; ///< strength that predictions of power assume, % of the box's diagonal

    bool operator==(const PublicParameters&) const = default;
};

/// An owner's key.
class Key {
public:
    /// Newest version of the file format that this library reads. It writes version 2 of keys that a
    /// passphrase protects, and version 1 of all others.
    static constexpr unsigned format_version = 2;

    /// A new random key. `name` is for people: one line of UTF-8, at most 200 bytes.
    /// \throw ParameterError  if the name or a parameter is out of range
    static Key generate(std::string name, PublicParameters parameters = {});

    /// Reads the text of a key file; messages call it `file_name`. `ask` is called if a passphrase protects
    /// it.
    /// \throw InputError  if it is no key file, cut, altered, of a newer version or has a value out of range,
    ///                    or the passphrase is missing or a wrong one
    static Key parse(std::string_view text, std::string_view file_name, const AskPassphrase& ask = {});

    /// \throw InputError  as `parse`, or if the file can't be read
    static Key load(const std::filesystem::path& path, const AskPassphrase& ask = {});

    /// Writes a new file that only its owner may read (mode 0600). Leaves nothing behind when it fails.
    /// \param passphrase  opens the file; null: whoever can read it has the key
    /// \throw OutputError  if the file exists or can't be written
    void save(const std::filesystem::path& path, const Passphrase* passphrase = nullptr) const;

    /// The text of the key file. It holds the secret, under the passphrase if there is one.
    std::string to_text(const Passphrase* passphrase = nullptr, const ProtectionCost& cost = {}) const;

    const std::string& name() const { return name_; }
    const std::string& created_by() const { return created_by_; }
    const PublicParameters& parameters() const { return parameters_; }
    const Secret& secret() const { return secret_; }
    std::string fingerprint() const { return key::fingerprint(secret_); }
    std::string commitment() const { return key::commitment(secret_); }

private:
    Key(std::string name, std::string created_by, PublicParameters parameters, Secret secret);

    std::string name_;
    std::string created_by_;
    PublicParameters parameters_;
    Secret secret_;
};

} // namespace wm3d::key
