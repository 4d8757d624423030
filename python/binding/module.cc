// The module tilemend._tilemend. python/tilemend/_fill.py is what users call.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "client/mesh/array_mesh.h"
#include "client/mesh/mesh_filler.h"
#include "client/mesh/mesh_options.h"
#include "common/options/job_options.h"
#include "common/options/option.h"
#include "common/util/error_info.h"
#include "common/util/stage_words.h"
#include "common/util/status_macros.h"
#include "common/util/utc.h"
#include "common/util/version.h"
#include "coordinator/report/scene_report.h"
#include "python/binding/array_view.h"
#include "python/binding/background.h"
#include "python/binding/interpreter_exit.h"
#include "python/binding/read_only_while.h"

namespace tilemend {
namespace {

namespace py = pybind11;

// Options of `fill` that arrays do not have: what is written, and colours.
bool IsOfFiles(const Option& option) {
  const std::string field = option.field;
  return field == "out" || field == "overwrite" || field == "water_colour";
}

bool IsWater(const Option& option) { return std::string_view(option.field) == "water"; }

bool IsOfArrays(const Option& option) { return (option.commands & kOfFill) != 0 && !IsOfFiles(option); }

std::vector<std::map<std::string, std::string>> OptionRows() {
  std::vector<std::map<std::string, std::string>> rows;
  for (const Option& option : AllOptions()) {
    if (!IsOfArrays(option)) continue;
    rows.push_back({{"name", option.field},
                    {"expected", Expected(option)},
                    {"default", IsWater(option) ? kMeshWater : option.default_value},
                    {"unit", option.unit},
                    {"help", option.help}});
  }
  return rows;
}

std::vector<std::pair<std::string, std::string>> StageRows() {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [beginning, words] : AllStageWords()) rows.emplace_back(beginning, words);
  return rows;
}

// The exception's class by the status, and the reason as its second argument.
[[noreturn]] void Throw(const absl::Status& status) {
  const py::module_ errors = py::module_::import("tilemend._errors");
  const py::object made =
      errors.attr("from_status")(static_cast<int>(status.code()), std::string(status.message()), ErrorReason(status));
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
  throw py::error_already_set();
}

absl::StatusOr<v1::JobSpec> SpecOf(const std::map<std::string, std::string>& texts) {
  for (const Option& option : AllOptions()) {
    if ((option.commands & kOfFill) != 0 && IsOfFiles(option) && texts.contains(option.field)) {
      return absl::InvalidArgumentError(absl::StrCat(option.field, ": arrays have no such option; leave it out"));
    }
  }
  std::map<std::string, std::string> all = texts;
  all.try_emplace("water", kMeshWater);
  TILEMEND_ASSIGN_OR_RETURN(v1::JobSpec spec, SpecFromTexts(all, kOfFill));
  TILEMEND_RETURN_IF_ERROR(CheckMeshOptions(spec, [&](const Option& option) { return texts.contains(option.field); }));
  return spec;
}

// The report as JSON.
absl::StatusOr<std::string> FillArrays(ArrayMesh& mesh, const v1::JobSpec& spec, const CancelToken& cancel,
                                       SharedStep& step) {
  TILEMEND_ASSIGN_OR_RETURN(MeshFillOptions options, MeshOptionsOf(spec));
  options.fill.refine.is_cancelled = [&] { return cancel.cancelled() || InterpreterEnds(); };
  options.show = [&](std::string_view name, size_t done, size_t all) { step.Set(name, done, all); };
  TILEMEND_ASSIGN_OR_RETURN(FilledMesh filled, FillMesh(mesh, options));
  filled.report.date = UtcText(absl::Now());
  filled.report.options = ReportedOptions(spec, kOfFill);
  return SceneReport(filled.report);
}

// An array that owns the rows of three numbers, without a copy.
template <typename Number>
py::array ArrayOf(std::vector<Number> numbers) {
  auto held = std::make_unique<std::vector<Number>>(std::move(numbers));
  const std::array<py::ssize_t, 2> shape = {static_cast<py::ssize_t>(held->size() / 3), 3};
  Number* const first = held->data();
  const py::capsule owner(held.get(), [](void* vector) { delete static_cast<std::vector<Number>*>(vector); });
  held.release();
  return py::array_t<Number>(shape, first, owner);
}

// Python may end the thread in here by unwinding its stack, without the GIL: so no object may be freed on the way.
void CallProgress(PyObject* progress, const SharedStep::Step& now) {
  PyObject* const answer = PyObject_CallFunction(progress, "snn", now.name.c_str(), static_cast<Py_ssize_t>(now.done),
                                                 static_cast<Py_ssize_t>(now.all));
  if (answer == nullptr) throw py::error_already_set();
  Py_DECREF(answer);
}

// (vertices, faces, number of original faces, report as JSON).
py::tuple Fill(const py::array& vertices, const py::array& faces, const std::map<std::string, std::string>& texts,
               const py::object& progress) {
  const auto spec = SpecOf(texts);
  if (!spec.ok()) Throw(spec.status());
  const ReadOnlyWhile vertices_stay(vertices), faces_stay(faces);
  auto mesh = ArrayMesh::Make(VertexView(vertices), FaceView(faces));
  if (!mesh.ok()) Throw(mesh.status());
  CancelToken cancel;
  SharedStep step;
  absl::StatusOr<std::string> report = absl::UnknownError("");
  FilledArrays filled;
  std::function<void(const SharedStep::Step&)> show;
  if (!progress.is_none()) {
    show = [&](const SharedStep::Step& now) { CallProgress(progress.ptr(), now); };
  }
  const auto work = [&] {
    report = FillArrays(*mesh, *spec, cancel, step);
    if (report.ok()) filled = mesh->Filled();
  };
  RunInBackground(work, cancel, step, show);
  if (!report.ok()) Throw(report.status());
  py::array all = std::visit([](auto numbers) { return ArrayOf(std::move(numbers)); }, std::move(filled.vertices));
  return py::make_tuple(std::move(all), ArrayOf(std::move(filled.faces)), filled.originals, *report);
}

PYBIND11_MODULE(_tilemend, module) {
  module.doc() = "Geometry of tilemend; use the package tilemend.";
  module.attr("RELEASE") = Version();
  WatchInterpreterExit();
  WatchForksOfReadOnly();
  module.def("options", &OptionRows);
  module.def("stages", &StageRows);
  module.def("fill", &Fill, py::arg("vertices"), py::arg("faces"), py::arg("options"), py::arg("progress"));
}

}  // namespace
}  // namespace tilemend
