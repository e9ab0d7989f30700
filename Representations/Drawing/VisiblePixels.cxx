// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisiblePixels.h"

#include "InspectionMesh.h"
#include "InspectionStyle.h"
#include "Shaders.h"
#include "ShapeConversion.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"
#include "vtkUnstructuredGrid.h"

#include <stdexcept>
#include <string>

#include "OpenGL.h"

namespace camaron
{
//------------------------------------------------------------------------------
void VisiblePixels::Resize(int width, int height)
{
  if (this->Framebuffer && this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  if (!this->Framebuffer)
  {
    glGenFramebuffers(1, &this->Framebuffer);
    glGenRenderbuffers(2, this->Buffers);
    glGenVertexArrays(1, &this->VertexArray);
  }
  const GLenum formats[2] = { GL_R32UI, GL_DEPTH_COMPONENT32F };
  for (int i = 0; i < 2; ++i)
  {
    glBindRenderbuffer(GL_RENDERBUFFER, this->Buffers[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  this->Size[0] = width;
  this->Size[1] = height;
}

//------------------------------------------------------------------------------
void VisiblePixels::Draw(vtkOpenGLRenderWindow* window, const Scene& scene)
{
  using State = vtkOpenGLState;
  State* state = window->GetState();
  const State::ScopedglViewport viewport(state);
  const State::ScopedglDepthMask depthMask(state);
  const State::ScopedglDepthFunc depthFunc(state);
  const State::ScopedglColorMask colorMask(state);
  const State::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  const State::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const State::ScopedglEnableDisable culling(state, GL_CULL_FACE);

  this->Resize(scene.Width, scene.Height);
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  glFramebufferRenderbuffer(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, this->Buffers[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->Buffers[1]);
  const GLenum attachment = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &attachment);
  glReadBuffer(attachment);
  const bool isComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (isComplete)
  {
    state->vtkglViewport(0, 0, scene.Width, scene.Height);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const GLuint nothing[4] = { Nothing, 0, 0, 0 };
    const GLfloat far = 1;
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far);
    this->DrawTriangles(window, scene);
    const std::size_t size = static_cast<std::size_t>(scene.Width) * scene.Height;
    this->Entries.resize(size);
    this->Depths.resize(size);
    state->vtkglPixelStorei(
      GL_PACK_ALIGNMENT, 1); // through VTK's state, which would otherwise not restore it
    glReadPixels(
      0, 0, scene.Width, scene.Height, GL_RED_INTEGER, GL_UNSIGNED_INT, this->Entries.data());
    glReadPixels(
      0, 0, scene.Width, scene.Height, GL_DEPTH_COMPONENT, GL_FLOAT, this->Depths.data());
  }
  state->PopFramebufferBindings();
  if (!isComplete)
  {
    throw std::runtime_error("Labels need an integer framebuffer, which the graphics card lacks.");
  }
}

//------------------------------------------------------------------------------
void VisiblePixels::DrawTriangles(vtkOpenGLRenderWindow* window, const Scene& scene)
{
  std::string vertex = VisiblePixelsVS, fragment = VisiblePixelsFS;
  const InspectionStyle& style = scene.Style;
  vtkShaderProgram::Substitute(vertex, "//Camaron::Defines",
    std::string(style.MovesCells() ? "#define HAS_CENTROIDS\n" : "") +
      (style.CutsExactly() ? "#define HAS_POSITION\n" : ""));
  vtkShaderProgram::Substitute(vertex, "//Camaron::Place", PlaceGLSL);
  if (style.CutsExactly())
  {
    vtkShaderProgram::Substitute(
      fragment, "//Camaron::CutExactly::Dec", std::string(InShapeGLSL) + CutExactlyGLSL);
    vtkShaderProgram::Substitute(fragment, "//Camaron::CutExactly::Impl", "cutExactly();");
  }
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    throw std::runtime_error("The graphics card cannot find the visible elements for labels.");
  }
  vtkOpenGLState* state = window->GetState();
  const bool cullsFront = scene.Property->GetFrontfaceCulling();
  const bool cullsBack = scene.Property->GetBackfaceCulling();
  state->SetEnumState(GL_CULL_FACE, cullsFront || cullsBack);
  if (cullsFront || cullsBack)
  {
    state->vtkglCullFace(cullsFront && cullsBack ? GL_FRONT_AND_BACK
        : cullsFront                             ? GL_FRONT
                                                 : GL_BACK);
  }
  vtkTextureUnitManager* units = window->GetTextureUnitManager();
  std::vector<int> used;
  const auto attach = [&](const char* name, const TextureBuffer& table)
  {
    if (program->IsUniformUsed(name))
    {
      used.push_back(units->Allocate());
      table.Bind(used.back());
      program->SetUniformi(name, used.back());
    }
  };
  attach("triangleTable", scene.Mesh.Triangles);
  attach("faceTable", scene.Mesh.Faces);
  attach("pointTable", scene.Mesh.Points);
  attach("markTable", scene.Mesh.Marks);
  attach("centroidTable", scene.Mesh.Centroids);
  // Also without a list a table of the right type must be bound.
  attach("visibleTable", scene.Visible ? *scene.Visible : scene.Mesh.Marks);
  program->SetUniformi("isListed", scene.Visible ? 1 : 0);
  program->SetUniformf("shrinkFactor", static_cast<float>(style.ShrinkFactor));
  program->SetUniformf("explodeFactor", static_cast<float>(style.ExplodeFactor));
  program->SetUniform3f("explodeCenter", style.GetExplodeCenter(scene.Mesh.GetMiddle()).data());
  if (style.CutsExactly())
  {
    const ShapeUniforms shape(style.ExactShape, scene.Mesh.GetMiddle());
    program->SetUniformi("numberOfPlanes", shape.NumberOfPlanes);
    program->SetUniform4fv("planes", ConvexShape::MaxPlanes, shape.Planes);
    program->SetUniformMatrix4x4("toUnitSphere", const_cast<float*>(shape.ToUnitSphere));
    program->SetUniformi("keepInside", style.KeepInside ? 1 : 0);
  }
  vtkNew<vtkMatrix4x4> columns;
  vtkMatrix4x4::Transpose(scene.ToDisplay, columns);
  program->SetUniformMatrix("toDisplay", columns);
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * scene.NumberOfTriangles));
  glBindVertexArray(0);
  for (const int unit : used)
  {
    units->Free(unit);
  }
  state->ResetGLActiveTexture();
  window->GetShaderCache()->ReleaseCurrentShader();
}

//------------------------------------------------------------------------------
void VisiblePixels::Release()
{
  if (this->Framebuffer)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteRenderbuffers(2, this->Buffers);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Framebuffer = this->VertexArray = 0;
  this->Entries = {};
  this->Depths = {};
}
}
