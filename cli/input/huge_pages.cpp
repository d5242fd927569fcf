// SPDX-License-Identifier: MIT
#include "cli/input/huge_pages.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;
constexpr std::size_t least_block = 2 * huge_page;
// By this much the heap grows at once; nothing of it counts before it is touched.
constexpr int heap_step = 1 << 26;
constexpr int greatest_in_heap = 1 << 25;                        // the most that malloc takes for it
constexpr std::size_t more_than_is_free = std::size_t{1} << 20;  // of the heap, before the first step

constexpr std::uintptr_t rounded_up(std::uintptr_t value, std::size_t unit) { return (value + unit - 1) / unit * unit; }

}  // namespace

namespace csgcast::cli {

void use_huge_pages() {
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  mallopt(M_TOP_PAD, heap_step);
  mallopt(M_TRIM_THRESHOLD, 2 * heap_step);
  mallopt(M_MMAP_THRESHOLD, greatest_in_heap);
  const auto begin = rounded_up(reinterpret_cast<std::uintptr_t>(sbrk(0)), huge_page);
  void* volatile block = std::malloc(more_than_is_free);  // volatile: else compilers do without
  std::free(block);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the heap is told by numbers alone
  if (end > begin) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace csgcast::cli

#ifndef __SANITIZE_ADDRESS__

namespace {

void* allocate_large(std::size_t size) {
  if (size > SIZE_MAX - huge_page) throw std::bad_alloc();
  const std::size_t whole = rounded_up(size, huge_page);
  void* const block = std::aligned_alloc(huge_page, whole);
  if (block == nullptr) throw std::bad_alloc();
  madvise(block, whole, MADV_HUGEPAGE);
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  if (size >= least_block) return allocate_large(size);
  if (void* const block = std::malloc(size > 0 ? size : 1)) return block;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  if (size >= least_block && static_cast<std::size_t>(alignment) <= huge_page) return allocate_large(size);
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* const block = size > SIZE_MAX - unit ? nullptr : std::aligned_alloc(unit, rounded_up(size, unit)))
    return block;
  throw std::bad_alloc();
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }

#endif
