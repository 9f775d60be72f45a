// Output.glsl: what a full-screen pass gives to blending, which puts it over the opaque picture: colour + transmittance * opaque.
//
// With one channel blending takes the transmittance from alpha, which is 1 - transmittance; with three from a second source colour.
//
// Needs: TRANSMITTANCE_CHANNELS.  Gives: writeOutput.
#ifndef Output_glsl
#define Output_glsl
#include "Common/Channels.glsl"

#if TRANSMITTANCE_CHANNELS == 3
layout(location = 0, index = 0) out vec4 fragOutput0;
layout(location = 0, index = 1) out vec4 transmittanceOutput;

void writeOutput(vec3 color, Channels transmittance)
{
  fragOutput0 = vec4(color, 1.0 - meanOf(transmittance));
  transmittanceOutput = vec4(transmittance, 0.0);
}
#else
out vec4 fragOutput0;

void writeOutput(vec3 color, Channels transmittance)
{
  fragOutput0 = vec4(color, 1.0 - transmittance);
}
#endif

#endif
