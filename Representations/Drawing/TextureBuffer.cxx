// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureBuffer.h"

#include <stdexcept>
#include <string>

#include "OpenGL.h"

namespace camaron
{
namespace
{
struct Format
{
  GLenum Name;
  std::size_t Bytes;
};

// In the order of TextureBuffer::Row.
constexpr Format Formats[] = {
  { GL_RGBA32F, 16 },
  { GL_RG32F, 8 },
  { GL_R32F, 4 },
  { GL_RGBA8, 4 },
  { GL_RGBA32UI, 16 },
  { GL_RG32UI, 8 },
  { GL_R32UI, 4 },
  { GL_R8UI, 1 },
};

const Format& GetFormat(TextureBuffer::Row row)
{
  return Formats[static_cast<int>(row)];
}
}

//------------------------------------------------------------------------------
void TextureBuffer::Upload(const void* rows, std::size_t numberOfRows)
{
  const Format& format = GetFormat(this->Kind);
  GLint maxRows = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &maxRows);
  if (numberOfRows > static_cast<std::size_t>(maxRows))
  {
    this->Release();
    throw std::length_error("Mesh Inspection needs a table of " + std::to_string(numberOfRows) +
      " rows, but tables of this graphics card have at most " + std::to_string(maxRows) + ".");
  }
  const bool isNew = this->Buffer == 0;
  if (isNew)
  {
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Texture);
  }
  // An empty buffer cannot be bound, so it gets one row that is never read.
  const std::size_t bytes = (numberOfRows > 0 ? numberOfRows : 1) * format.Bytes;
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), numberOfRows > 0 ? rows : nullptr,
    GL_STATIC_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  if (isNew)
  {
    GLint bound = 0; // texture of the current unit, for a program that is about to run
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &bound);
    glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
    glTexBuffer(GL_TEXTURE_BUFFER, format.Name, this->Buffer);
    glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(bound));
  }
  this->NumberOfRows = numberOfRows;
}

//------------------------------------------------------------------------------
void TextureBuffer::Resize(std::size_t numberOfRows)
{
  if (!this->IsUploaded() || this->NumberOfRows != numberOfRows)
  {
    this->Upload(nullptr, numberOfRows);
  }
}

//------------------------------------------------------------------------------
void TextureBuffer::Write(std::size_t numberOfRows, const std::function<void(void*)>& write)
{
  this->Upload(nullptr, numberOfRows);
  if (numberOfRows == 0)
  {
    return;
  }
  const auto bytes = static_cast<GLsizeiptr>(numberOfRows * GetFormat(this->Kind).Bytes);
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  bool isLost = true; // memory may be lost, for example when the screen mode changes
  while (isLost)
  {
    void* const rows = glMapBufferRange(
      GL_TEXTURE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (!rows)
    {
      glGetError(); // clears the error that glMapBufferRange set
      glBindBuffer(GL_TEXTURE_BUFFER, 0);
      this->Release();
      throw std::runtime_error("Mesh Inspection needs a table of " + std::to_string(bytes) +
        " bytes, which exceeds the free memory of the graphics card.");
    }
    write(rows);
    isLost = !glUnmapBuffer(GL_TEXTURE_BUFFER);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void TextureBuffer::Download(void* rows, std::size_t numberOfRows) const
{
  const std::size_t bytes = numberOfRows * GetFormat(this->Kind).Bytes;
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glGetBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), rows);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void TextureBuffer::Bind(int unit) const
{
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
}

//------------------------------------------------------------------------------
void TextureBuffer::Release()
{
  if (this->Buffer)
  {
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->Texture = this->Buffer = 0;
  this->NumberOfRows = 0;
}
}
