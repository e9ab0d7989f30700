// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Buffer
 * @brief Exactly sized, uninitialized memory for large arrays, which VTK arrays can take over.
 *
 * Large buffers request huge pages if the system has them; otherwise page faults take most of the
 * time of filling a new array.
 */
#ifndef camaron_Buffer_h
#define camaron_Buffer_h

#include "Base/RangedArray.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkSmartPointer.h"

#include <cstddef>     // for std::size_t
#include <new>         // for construct
#include <type_traits> // for std::is_trivial
#include <utility>     // for std::exchange
#include <vector>      // for LargeVector

namespace camaron
{
/// Release the memory with FreeLarge or std::free. @throw std::bad_alloc
void* AllocateLarge(std::size_t bytes);
void FreeLarge(void* memory);

/// Allocates the same memory for standard containers. Values without a constructor stay
/// uninitialized when a container grows without given values.
template <typename Value>
struct LargeAllocator
{
  using value_type = Value;
  LargeAllocator() = default;
  template <typename Other>
  LargeAllocator(const LargeAllocator<Other>&)
  {
  }
  Value* allocate(std::size_t size)
  {
    return static_cast<Value*>(AllocateLarge(size * sizeof(Value)));
  }
  void deallocate(Value* memory, std::size_t) { FreeLarge(memory); }
  template <typename Other>
  void construct(Other* place)
  {
    ::new (static_cast<void*>(place)) Other;
  }
  template <typename Other, typename... Arguments>
  void construct(Other* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
  }
  template <typename Other>
  bool operator==(const LargeAllocator<Other>&) const
  {
    return true;
  }
  template <typename Other>
  bool operator!=(const LargeAllocator<Other>&) const
  {
    return false;
  }
};
template <typename Value>
using LargeVector = std::vector<Value, LargeAllocator<Value>>;

template <typename Value>
class Buffer
{
public:
  static_assert(std::is_trivial<Value>::value, "the memory is not initialized");

  Buffer() = default;
  explicit Buffer(vtkIdType size)
    : Values(static_cast<Value*>(AllocateLarge(static_cast<std::size_t>(size) * sizeof(Value))))
    , Size(size)
  {
  }
  Buffer(Buffer&& other) noexcept
    : Values(std::exchange(other.Values, nullptr))
    , Size(std::exchange(other.Size, 0))
  {
  }
  Buffer& operator=(Buffer&& other) noexcept
  {
    std::swap(this->Values, other.Values);
    std::swap(this->Size, other.Size);
    return *this;
  }
  ~Buffer() { FreeLarge(this->Values); }

  Value* data() { return this->Values; }
  const Value* data() const { return this->Values; }
  vtkIdType size() const { return this->Size; }
  /// Drops the last values; their memory stays allocated.
  void Shrink(vtkIdType size) { this->Size = size; }
  Value& operator[](vtkIdType i) { return this->Values[i]; }
  const Value& operator[](vtkIdType i) const { return this->Values[i]; }

  /// Transfers the memory to a VTK array of class @a Array with the same value type.
  template <typename Array>
  vtkSmartPointer<Array> TakeArray(int numberOfComponents = 1, const char* name = nullptr)
  {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfComponents(numberOfComponents);
    if (this->Size > 0)
    {
      array->SetArray(this->Values, this->Size, 0, Array::VTK_DATA_ARRAY_FREE);
    }
    else
    {
      FreeLarge(this->Values);
    }
    this->Values = nullptr;
    this->Size = 0;
    return array;
  }

private:
  Value* Values = nullptr;
  vtkIdType Size = 0;
};

/// An uninitialized VTK array of class @a Array with one component in such memory.
template <typename Array>
vtkSmartPointer<Array> MakeLargeArray(vtkIdType size)
{
  return Buffer<typename Array::ValueType>(size).template TakeArray<RangedArray<Array>>();
}
}

#endif
