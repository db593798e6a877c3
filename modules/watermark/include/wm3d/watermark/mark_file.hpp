// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Marks in the user's own files: coordinates change, every other byte stays, and nothing is written
/// in which the mark would not be found again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <wm3d/io/file.hpp>
#include <wm3d/io/model.hpp>
#include <wm3d/resync/receipt.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/rehearsal.hpp>
#include <wm3d/watermark/verify.hpp>

namespace wm3d::watermark {

/// Why a mark that was laid down isn't found again.
enum class Loss {
    none,     ///< it is found
    power,    ///< the mesh is too small or too plain for it, or its shape has no clear axes
    storage,  ///< the file's coordinates are too coarse for it
    content,  ///< it is found, but what it says besides can't be read
    distance, ///< the model lies so far from the origin that the file's numbers hold no more than steps of it
    visibility, ///< none was laid down: every mark of the surface is seen more than was allowed
};

struct MarkModelOptions {
    MarkOptions mark;                        ///< what is laid down
    io::Normals normals = io::Normals::keep; ///< those that the file stores
    std::string output_name{}; ///< file it will be written as; empty: a stream, with no files beside it
};

/// A marked model as it would be written, and what verify says of it.
struct MarkedModel {
    Marked marked; ///< of which the ambiguity alone is known where every mark is seen too much
    io::PatchedFiles files;
    VerifyReport check;
    std::vector<Rehearsed> rehearsed; ///< what it will bear; empty where it isn't found
    Loss loss = Loss::none;
    std::string remedy{}; ///< for a loss: what was tried and would do, such as "--visibility 0.2 would do"
    double coordinate_step = 0; ///< as io::Model's; a move well below it is lost
};

/// Marks a model, patches its bytes, reads these again and verifies them. Nothing is written. A copy of its own whose
/// mark isn't found is tried once more with more of the mark in the common part.
/// \throw ParameterError, GeometryError  as `mark`
/// \throw InputError                     with Normals::turn, if the normals can't be understood
MarkedModel mark_model(const io::Model& model, const key::Key& key, const MarkModelOptions& options = {},
                       const Progress& progress = {});

/// A sentence for a loss: what was tried, what would mend it.
/// \pre  result.loss != Loss::none
std::string describe_loss(const MarkedModel& result, double pf);

/// The receipt of a marked model, by which cut or ambiguous copies are found again.
resync::Receipt make_receipt(const io::Model& model, const MarkedModel& result, const key::Key& key,
                             const Progress& progress = {});

/// `mark` rewrites coordinates inside the user's own file: another format would be another file.
/// \throw ParameterError  naming the output
void require_same_format(io::Format in, io::Format out, std::string_view output);

struct MarkFileOptions {
    MarkOptions mark;                        ///< what is laid down
    io::Normals normals = io::Normals::keep; ///< those that the file stores
    std::optional<io::Format> format{};      ///< of both files; default: by their extensions
    std::filesystem::path receipt{};         ///< also write what finds cut or ambiguous copies; empty: don't
    bool overwrite = false;                  ///< replace files that exist
};

/// What became of a file.
struct MarkedFile {
    bool written = false; ///< false where the mark would not be found again
    std::string reason{}; ///< why nothing was written, in a sentence
    Marked marked;
    VerifyReport check;
    std::vector<Rehearsed> rehearsed{}; ///< as MarkedModel's
};

/// Marks the mesh file `in` and writes it as `out`, in the same format, as a whole or not at all.
/// \throw InputError                     if `in` is no mesh
/// \throw OutputError                    if a file is in the way, or can't be written
/// \throw ParameterError, GeometryError  as `mark`; or if `out` is to be of another format
MarkedFile mark_file(const std::filesystem::path& in, const std::filesystem::path& out, const key::Key& key,
                     const MarkFileOptions& options = {}, const Progress& progress = {});

} // namespace wm3d::watermark
