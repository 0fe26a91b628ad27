#pragma once

#include <filesystem>
#include <string_view>

namespace toccata {

/// The files for people that Toccata makes. Each holds a mark by which it knows its own again.
enum class OutputKind { page, glb, picture, plot, case_file, junit, sarif, bcf };

/// Throws Error naming the file when write_output would refuse it: it exists and was not written by Toccata as this
/// kind, is no regular file, or its folder is missing or cannot be written to; of a page or GLB file also when its name
/// ends in that of another format (.obj, .png, .json, …). For asking before long work.
void require_output(const std::filesystem::path& path, OutputKind kind);

/// Writes a file: it is complete or not there. A file is replaced only when it is empty or one of Toccata's of the same
/// kind. `bytes` are what view_page, scene_glb or plot_svg made (write_case writes cases); a picture is any PNG, and
/// gets the mark on the way. Throws Error naming the file as require_output does, when the disk is full, and when a
/// picture is no PNG.
void write_output(std::string_view bytes, const std::filesystem::path& path, OutputKind kind);

}  // namespace toccata
