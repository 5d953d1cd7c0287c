#pragma once

#include <string>
#include <vector>

namespace dsphere {

/// Something that a user should know about a scene or a map although it can be used as it is.
struct Notice {
    enum class Kind {
        Note,     ///< nothing is wrong: a parameter that cannot change the picture, a column that was dropped
        Warning,  ///< the picture may not be what was meant: colours taken as heights, an eye under the ground
    };

    Kind kind = Kind::Note;
    std::string text;  ///< one line without a full stop; begins with "file:line:column: " or "file: "

    bool operator==(const Notice&) const = default;
};

using Notices = std::vector<Notice>;

}  // namespace dsphere
