// What tiles and filled faces look like, to payload messages and back.
#ifndef TILEMEND_COMMON_RPC_LOOK_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_LOOK_PAYLOADS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "common/records/fill_colour.h"
#include "common/records/tile_files.h"
#include "common/util/colour.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// The values of BoundaryVertices::colour.
uint32_t ColourToProto(const std::optional<Rgb>& colour);
std::optional<Rgb> ColourFromProto(uint32_t value);

// Decoding gives kInvalidArgument for a path that is empty, absolute or leads out of the scene's folder.
v1::TileFiles ToProto(const TileFiles& files);
absl::StatusOr<TileFiles> FromProto(const v1::TileFiles& proto);

// Adds to a witness, and gets what was added. The witness comes back from workers: its paths may be anything.
void SetWitness(const FileWitness& files, v1::TileWitness& witness);
FileWitness WitnessOf(const v1::TileWitness& witness);

// Sets the colours of an AssembleInput, and gets them; kInvalidArgument for a hole that is there twice.
void SetColours(const FillColours& colours, v1::AssembleInput& input);
absl::StatusOr<FillColours> ColoursOf(const v1::AssembleInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_LOOK_PAYLOADS_H_
