// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TextureBuffer
 * @brief A table in graphics memory that shaders read by row (a texture buffer of OpenGL 3.1).
 *
 * VTK's own texture buffers have no integer rows. All methods need the context of the window
 * current.
 */
#ifndef camaron_TextureBuffer_h
#define camaron_TextureBuffer_h

#include <cstddef>    // for sizes
#include <functional> // for the one that writes

namespace camaron
{
class TextureBuffer
{
public:
  /// What a row holds.
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
   * Replaces the table; null leaves its rows undefined, for the graphics card to write.
   * @throw std::length_error for more rows than the graphics card's textures have
   */
  void Upload(const void* rows, std::size_t numberOfRows);
  /// Sees to that there are so many rows, perhaps none, for the graphics card to write. @throw as
  /// Upload
  void Resize(std::size_t numberOfRows);
  /**
   * Replaces the table by what @a write(rows) writes there, which may be from several threads; it
   * must not read.
   * @throw std::length_error as Upload, std::runtime_error without memory for it
   */
  void Write(std::size_t numberOfRows, const std::function<void(void*)>& write);
  /// Fetches the first rows, of which there must be as many.
  void Download(void* rows, std::size_t numberOfRows) const;
  /// Makes the table known to shaders as the texture of a unit (0, 1, ...).
  void Bind(int unit) const;
  /// Gives the memory back; the table can be uploaded again.
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
