// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TextureBuffer
 * @brief A table in graphics memory that shaders read by row (a texture buffer of OpenGL 3.1).
 *
 * VTK's vtkTextureObject supports no integer rows. All methods require that the context of the
 * window is current.
 */
#ifndef camaron_TextureBuffer_h
#define camaron_TextureBuffer_h

#include <cstddef>    // for sizes
#include <functional> // for the function that writes

namespace camaron
{
class TextureBuffer
{
public:
  /// Type of a row.
  enum class Row
  {
    Float4, ///< vec4
    Float2, ///< vec2
    Float,  ///< float
    Color,  ///< four bytes as a vec4 from 0 to 1
    UInt4,  ///< uvec4
    UInt2,  ///< uvec2
    UInt,   ///< uint
    Byte    ///< one byte as a uint
  };

  explicit TextureBuffer(Row row)
    : Kind(row)
  {
  }
  TextureBuffer(const TextureBuffer&) = delete;
  TextureBuffer& operator=(const TextureBuffer&) = delete;

  /**
   * Replaces the table. Null leaves its rows undefined, to be written by the graphics card.
   *
   * @throw std::length_error if the graphics card does not support that many rows
   */
  void Upload(const void* rows, std::size_t numberOfRows);
  /// Provides a table of this size, which may be 0, for the graphics card to write. @throw as
  /// Upload
  void Resize(std::size_t numberOfRows);
  /**
   * Replaces the table by what @a write(rows) writes, possibly with several threads. It must not
   * read.
   *
   * @throw std::length_error as Upload; std::runtime_error if there is not enough memory
   */
  void Write(std::size_t numberOfRows, const std::function<void(void*)>& write);
  /// Fetches the first @a numberOfRows rows, which must exist.
  void Download(void* rows, std::size_t numberOfRows) const;
  /// Binds the table to a texture unit (0, 1, ...) for shaders.
  void Bind(int unit) const;
  /// Frees the memory. The table can be uploaded again.
  void Release();

  bool IsUploaded() const { return this->Buffer != 0; }
  unsigned int GetBuffer() const { return this->Buffer; }
  std::size_t GetNumberOfRows() const { return this->NumberOfRows; }

private:
  const Row Kind;
  unsigned int Buffer = 0;
  unsigned int Texture = 0;
  std::size_t NumberOfRows = 0;
};
}

#endif
