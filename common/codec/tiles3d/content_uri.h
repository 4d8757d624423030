// URIs in a tileset, and which files they may mean.
#ifndef TILEMEND_COMMON_CODEC_TILES3D_CONTENT_URI_H_
#define TILEMEND_COMMON_CODEC_TILES3D_CONTENT_URI_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace tilemend {

// The path that `uri` means in the file `document`. Both paths are relative to the tileset's folder, with "/" and
// without "." and "..". Percent-encoding is decoded. kInvalidArgument, without the document's name, for a URI with a
// scheme, an authority, a root, a query or a fragment. The same for "..", a backslash or a control character in it.
absl::StatusOr<std::string> ResolveContentUri(std::string_view document, std::string_view uri);

// The URI of a path relative to the document's folder, with "/": all but letters, digits and "-._~/" is
// percent-encoded.
std::string ContentUriOf(std::string_view path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_CONTENT_URI_H_
