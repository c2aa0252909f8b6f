// Files by their names in UTF-8. How one is written: it appears whole or not at all, beside its place first and then
// renamed. A symbolic link stays one, and the file that it leads to is replaced; a device, a pipe or an open descriptor
// (/dev/stdout) is written to; a named pipe waits for its reader. A file that may not be written is not replaced. No
// signal of a pipe or of a limit reaches the process: the write fails.
#pragma once
#include <fstream>
#include <optional>
#include <string>
#include <system_error>

namespace ups::platform {

// Binary. Failed where there is no such file, it may not be read, or reading might never end or begin: of a folder, a
// device, or a pipe that is not open in this process (as /dev/stdin is, and what a shell puts for <(command)).
std::ifstream open_to_read(const std::string& path);

// It is on the disk when this returns. Throws std::system_error: "cannot write 'PATH': WHY".
void replace_file(const std::string& path, const void* bytes, size_t size);

// The folder in which replace_file() makes its file; none where the path names a device or the like, which takes bytes.
// Throws as replace_file().
std::optional<std::string> folder_written_in(const std::string& path);

// Why no file can be made in the folder: tries it, and leaves nothing.
std::error_code try_folder(const std::string& folder);

// In English or the words of the C library.
std::string message_of(const std::error_code& error);

}  // namespace ups::platform
