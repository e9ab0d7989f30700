// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Gzip.h
 * @brief Compresses bytes as gzip does.
 */
#ifndef camaron_Gzip_h
#define camaron_Gzip_h

#include "vtk_zlib.h"

#include <gtest/gtest.h>

#include <string>

namespace camaron
{
namespace testing
{
inline std::string Gzip(const std::string& bytes)
{
  constexpr int GzipFormat = 16;
  z_stream stream = {};
  EXPECT_EQ(
    deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + GzipFormat, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&packed[0]);
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}
}
}

#endif
