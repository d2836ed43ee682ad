// The only include of the OpenGL loader. Headers of this folder never need it: they hold plain numbers, so
// that the interface can use them without seeing OpenGL.
#pragma once

#include <glad/gl.h>
