// Names in an output's folder that are the program's own.
#ifndef TILEMEND_COMMON_RECORDS_OUTPUT_NAMES_H_
#define TILEMEND_COMMON_RECORDS_OUTPUT_NAMES_H_

#include <string>

namespace tilemend {

// What a complete output has beside its tiles; the report comes first.
inline constexpr const char* kReportFiles[] = {"report.json", "holes.geojson", "breaklines.geojson",
                                               "report.html", "holes.csv",     "acceptance.json"};
// What the acceptance check found.
inline constexpr const char* kAcceptanceFile = kReportFiles[5];
// What says where its tiles lie.
inline constexpr char kSceneFile[] = "scene.json";
inline constexpr char kMetadataFile[] = "metadata.xml";
// Where a job is at work, or was not finished: its key (coordinator/store/output_folder.h).
inline constexpr char kJobMarker[] = ".tilemend-job";
// The beginning of the names of all hidden files and folders.
inline constexpr char kHiddenPrefix[] = ".tilemend-";

// Whether `path`, relative to the output's folder, may be a file that a job writes or replaces itself: one of the above
// or a mesh, as every tile is one. Whoever names it may spell it in capitals or with "." and "..". Such a file is never
// carried from the scene: it would take the place of the job's own.
bool IsOutputName(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_OUTPUT_NAMES_H_
