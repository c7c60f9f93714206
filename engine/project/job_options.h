#pragma once
// Values of command-line options that describe what is rendered: lights, cameras, colours, sizes. What is wrong is
// ErrorKind::usage with what was expected; `place` names the option, such as "--light".
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/vec.h"
#include "engine/scene/camera.h"
#include "engine/scene/light.h"

namespace vamp {

// "rect,center=0,1,0,target=0,0,0,size=0.5x0.5,power=20[,color=1,1,1][,roll=deg][,name=key]". Lengths in scene units.
// Commas separate keys and the components of a vector: a piece without "=" continues the value before it.
//   rect         center target size power
//   disk         center target radius power
//   sphere       center radius power
//   point        center power
//   spot         center target power [inner outer]    half angles in degrees
//   directional  center target power                  shines from center to target; power in W per square unit
// color is linear "r,g,b" or sRGB "#rrggbb". Keys that a type has no use for are refused.
Result<Light> parse_light(std::string_view value, std::string_view place);

// "eye=x,y,z,target=x,y,z,fov=deg[,up=x,y,z]"; fov is vertical, 1 to 170 degrees.
Result<Camera> parse_camera(std::string_view value, std::string_view place);

// "r,g,b", linear, 0 or more; or "#rrggbb", sRGB.
Result<vec3> parse_color(std::string_view value, std::string_view place);

// "WxH" in pixels, each from 1 to 16384.
Result<uvec2> parse_size(std::string_view value, std::string_view place);

}  // namespace vamp
