// SPDX-License-Identifier: BSD-3-Clause
// A render window without a screen: VTK's OpenGL on Mesa's software rasteriser in memory (OSMesa).
// Debian's VTK 9.1 has no such window of its own; later VTK picks one by itself.
#include "vtkio/offscreen_window.h"

#include "core/error.h"
#include "vtkio/vtk_errors.h"

#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderingOpenGLConfigure.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)

static vtkSmartPointer<vtkOpenGLRenderWindow> new_window()
{
  return vtkSmartPointer<vtkOpenGLRenderWindow>::New();
}

#elif defined(VTK_OPENGL_HAS_OSMESA)

#include <vtkOSOpenGLRenderWindow.h>
static vtkSmartPointer<vtkOpenGLRenderWindow> new_window()
{
  return vtkSmartPointer<vtkOSOpenGLRenderWindow>::New();
}

#else

#include <GL/glew.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>

// glew.h has taken these two away, which osmesa.h needs.
#define GLAPI extern
#define GLAPIENTRY
#include <GL/osmesa.h>

#include <vector>

// GLEW asks GLX for the addresses of OpenGL's functions. There is no GLX here, so the program answers itself;
// a definition in the program comes before those in libraries.
using Function = void (*)();
extern "C" Function glXGetProcAddressARB(const unsigned char* name);
extern "C" Function glXGetProcAddress(const unsigned char* name);
Function glXGetProcAddressARB(const unsigned char* name)
{
  return reinterpret_cast<Function>(OSMesaGetProcAddress(reinterpret_cast<const char*>(name)));
}
Function glXGetProcAddress(const unsigned char* name) { return glXGetProcAddressARB(name); }

namespace {

class OffscreenWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static OffscreenWindow* New();
  vtkTypeMacro(OffscreenWindow, vtkGenericOpenGLRenderWindow);

  void Render() override
  {
    Initialize();
    if (Initialized)
      Superclass::Render();
  }
  void Initialize() override
  {
    if (Initialized)
      return;
    if (!make_context()) {
      vtkErrorMacro("OSMesa gives no OpenGL 3.2 context");
      return;
    }
    OpenGLInitContext();
    if (Initialized)
      OpenGLInit();
  }
  void OpenGLInitContext() override
  {
    if (Initialized)
      return;
    ContextCreationTime.Modified();
    glewExperimental = GL_TRUE;
    // GLEW loads every function before it misses GLX, so that only a missing version is a real failure.
    if (glewInit() == GLEW_ERROR_NO_GL_VERSION || !GLEW_VERSION_3_2) {
      vtkErrorMacro("OpenGL 3.2 is needed; is OSMesa linked before VTK?");
      return;
    }
    GlewInitValid = Initialized = true;
    GLfloat widths[2] = {1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    MaximumHardwareLineWidth = widths[1];
  }
  void Finalize() override
  {
    if (Initialized) {
      MakeCurrent();
      Superclass::Finalize();
    }
    if (context_)
      OSMesaDestroyContext(context_);
    context_ = nullptr;
    Initialized = false;
  }
  void MakeCurrent() override
  {
    if (!context_)
      return;
    const int* size = GetActualSize();
    const int width = std::max(size[0], 1), height = std::max(size[1], 1);
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height);
  }
  bool IsCurrent() override { return context_ && OSMesaGetCurrentContext() == context_; }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 0; }

protected:
  OffscreenWindow()
  {
    SetOffScreenRendering(true);
    SetFrameBlitModeToNoBlit(); // there is no screen to copy to
  }
  ~OffscreenWindow() override { Finalize(); }

private:
  bool make_context()
  {
    const int wanted[] = {OSMESA_FORMAT,
                          OSMESA_RGBA,
                          OSMESA_DEPTH_BITS,
                          24,
                          OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          3,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          2,
                          0};
    context_ = OSMesaCreateContextAttribs(wanted, nullptr);
    MakeCurrent();
    return IsCurrent();
  }

  OSMesaContext context_ = nullptr;
  std::vector<unsigned char> pixels_;
};
vtkStandardNewMacro(OffscreenWindow);

} // namespace

static vtkSmartPointer<vtkOpenGLRenderWindow> new_window() { return vtkSmartPointer<OffscreenWindow>::New(); }

#endif

namespace birdstrike {

vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height)
{
  vtkSmartPointer<vtkOpenGLRenderWindow> window = new_window();
  auto errors = vtkSmartPointer<VtkErrors>::New();
  errors->watch(*window);
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0); // several samples a pixel cost two to three times as much on a CPU
  window->SetSize(width, height);
  window->Initialize();
  if (errors->any() || !window->SupportsOpenGL())
    throw OutputError("cannot draw pictures: " + errors->first());
  return window;
}

vtkSmartPointer<vtkImageData> render_image(vtkRenderWindow& window)
{
  window.Render();
  auto grab = vtkSmartPointer<vtkWindowToImageFilter>::New();
  grab->SetInput(&window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  return grab->GetOutput();
}

} // namespace birdstrike
