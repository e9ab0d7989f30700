// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenGL.h
 * @brief The OpenGL functions as loaded by VTK: with GLEW up to 9.3, with glad since then. Include
 * it last.
 */
#ifndef camaron_OpenGL_h
#define camaron_OpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
