/**
 * OpenGL's state as OpenGL itself tells it, to compare before and after something was drawn.
 */
#ifndef GLState_h
#define GLState_h

#include <map>
#include <string>
#include <vector>

using GLState = std::map<std::string, std::vector<double>>;

/// The state of the context that is current.
GLState QueryGLState();

/// The errors that the context that is current has kept, and forgets now.
std::vector<std::string> TakeGLErrors();

/// Whether zink draws: for what it can't do (Documentation/Drivers.md).
bool IsZink();

#endif
