// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeedbackProgram.h"

#include "ShapeConversion.h"
#include "TextureBuffer.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "OpenGL.h"

namespace camaron
{
namespace
{
// Returns the shader; or 0 with the message of the compiler in `error`.
GLuint Compile(GLenum kind, const char* source, std::string& error)
{
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled)
  {
    return shader;
  }
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(length + 1, '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  glDeleteShader(shader);
  error = log.data();
  return 0;
}
}

//------------------------------------------------------------------------------
void FeedbackProgram::Build(
  const char* purpose, const char* vertex, const char* geometry, const char* output)
{
  if (this->Program)
  {
    return;
  }
  std::string error;
  const GLuint program = glCreateProgram();
  const auto attach = [&](GLenum kind, const char* source)
  {
    const GLuint shader = Compile(kind, source, error);
    if (shader)
    {
      glAttachShader(program, shader);
      glDeleteShader(shader); // freed together with the program
    }
    return shader != 0;
  };
  GLint linked = 0;
  if (attach(GL_VERTEX_SHADER, vertex) && (!geometry || attach(GL_GEOMETRY_SHADER, geometry)))
  {
    glTransformFeedbackVaryings(program, 1, &output, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
    {
      char log[512] = "";
      glGetProgramInfoLog(program, sizeof(log), nullptr, log);
      error = log;
    }
  }
  if (!linked)
  {
    glDeleteProgram(program);
    throw std::runtime_error(std::string("The graphics card cannot ") + purpose + ": " + error);
  }
  this->Program = program;
  glGenVertexArrays(1, &this->VertexArray);
  glGenQueries(1, &this->Query);
}

//------------------------------------------------------------------------------
void FeedbackProgram::Use() const
{
  glUseProgram(this->Program);
}

//------------------------------------------------------------------------------
void FeedbackProgram::SetUniform(const char* name, int value) const
{
  glUniform1i(glGetUniformLocation(this->Program, name), value);
}

//------------------------------------------------------------------------------
void FeedbackProgram::SetUniform(const char* name, float value) const
{
  glUniform1f(glGetUniformLocation(this->Program, name), value);
}

//------------------------------------------------------------------------------
void FeedbackProgram::SetShape(const ShapeUniforms& shape) const
{
  this->SetUniform("numberOfPlanes", shape.NumberOfPlanes);
  glUniform4fv(
    glGetUniformLocation(this->Program, "planes"), ConvexShape::MaxPlanes, shape.Planes[0]);
  glUniformMatrix4fv(
    glGetUniformLocation(this->Program, "toUnitSphere"), 1, GL_FALSE, shape.ToUnitSphere);
}

//------------------------------------------------------------------------------
void FeedbackProgram::SetTable(const char* name, const TextureBuffer& table, int unit) const
{
  table.Bind(unit);
  this->SetUniform(name, unit);
}

//------------------------------------------------------------------------------
std::size_t FeedbackProgram::Run(std::size_t numberOfPoints, TextureBuffer& output) const
{
  const std::size_t rows = this->Run(output, [&] { this->Draw(0, numberOfPoints); });
  return std::min(rows, output.GetNumberOfRows());
}

//------------------------------------------------------------------------------
std::size_t FeedbackProgram::RunToEnd(
  TextureBuffer& output, const std::function<void()>& draw) const
{
  constexpr std::size_t FirstCapacity = 1 << 15; // rows
  if (!output.IsUploaded())
  {
    output.Upload(nullptr, FirstCapacity);
  }
  std::size_t rows = this->Run(output, draw);
  if (rows > output.GetNumberOfRows())
  {
    output.Upload(nullptr, rows + rows / 8);
    rows = this->Run(output, draw);
  }
  return rows;
}

//------------------------------------------------------------------------------
void FeedbackProgram::DrawBlocks(const std::vector<std::uint32_t>& starts,
  const std::function<bool(std::size_t block)>& isWanted) const
{
  const std::size_t numberOfBlocks = starts.empty() ? 0 : starts.size() - 1;
  for (std::size_t block = 0; block < numberOfBlocks; ++block)
  {
    const std::size_t first = block;
    while (block < numberOfBlocks && isWanted(block))
    {
      ++block;
    }
    if (block > first)
    {
      this->Draw(starts[first], starts[block] - starts[first]);
    }
  }
}

//------------------------------------------------------------------------------
// Returns the number of rows that are generated, even if not all fit into the output.
std::size_t FeedbackProgram::Run(TextureBuffer& output, const std::function<void()>& draw) const
{
  GLuint rows = 0;
  glBindVertexArray(this->VertexArray);
  glEnable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, output.GetBuffer());
  glBeginQuery(GL_PRIMITIVES_GENERATED, this->Query);
  glBeginTransformFeedback(GL_POINTS);
  draw();
  glEndTransformFeedback();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glDisable(GL_RASTERIZER_DISCARD);
  glBindVertexArray(0);
  glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &rows);
  return rows;
}

//------------------------------------------------------------------------------
void FeedbackProgram::Draw(std::size_t firstPoint, std::size_t numberOfPoints) const
{
  glDrawArrays(GL_POINTS, static_cast<GLint>(firstPoint), static_cast<GLsizei>(numberOfPoints));
}

//------------------------------------------------------------------------------
void FeedbackProgram::Release()
{
  if (this->Program)
  {
    glDeleteProgram(this->Program);
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteQueries(1, &this->Query);
  }
  this->Program = this->VertexArray = this->Query = 0;
}
}
