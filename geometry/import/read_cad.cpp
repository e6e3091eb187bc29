// SPDX-License-Identifier: GPL-3.0-or-later
// STEP and IGES: the module that knows them is loaded where it is there and needed only, because OpenCASCADE's 60
// libraries would slow down every start of every program.
#include "core/error.h"
#include "geometry/import/cad_module.h"
#include "geometry/import/formats.h"

#include <dlfcn.h>

namespace birdstrike {

namespace {

//! Beside the library that this function is in.
std::filesystem::path module_file()
{
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&cad_is_read), &library) == 0 || !library.dli_fname)
    return {};
  return std::filesystem::path(library.dli_fname).parent_path() / "libbirdstrike_cad.so";
}

} // namespace

bool cad_is_read()
{
  std::error_code error;
  return std::filesystem::exists(module_file(), error);
}

RawScene read_cad(const std::filesystem::path& file, double coarseness)
{
  const std::string text = "mesh file '" + file.string() + "'";
  require(cad_is_read(),
          text + " holds curved CAD faces, which this build cannot read; export STL, OBJ or glTF, or "
                 "build with OpenCASCADE (Debian: libocct-data-exchange-dev)");
  void* module = dlopen(module_file().c_str(), RTLD_NOW | RTLD_LOCAL);
  void* entry = module ? dlsym(module, cad_module_entry) : nullptr;
  if (!entry) {
    const char* reason = dlerror();
    throw InputError(text +
                     " holds curved CAD faces, and OpenCASCADE, which reads them, cannot be started (" +
                     (reason ? reason : "no reason given") + "); export STL, OBJ or glTF");
  }
  RawScene scene;
  reinterpret_cast<CadModuleEntry*>(entry)(file, coarseness, scene);
  return scene; // the module stays loaded: it may have left functions to be called at the end
}

} // namespace birdstrike
