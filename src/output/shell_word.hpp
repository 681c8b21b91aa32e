#pragma once
/// Names of files within commands that a user is advised to type.
#include <filesystem>
#include <string>

namespace starling {

/// The path as one word of a POSIX shell: quoted where it holds more than letters, digits and
/// "._-/+=:@%,".
inline std::string shell_word(const std::filesystem::path& path)
{
    const std::string text = path.string();
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "._-/+=:@%,";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

} // namespace starling
