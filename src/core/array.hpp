#pragma once
/// Owned, zeroed, cache-line aligned storage.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

#include <sys/mman.h>

#include "core/types.hpp"

namespace starling {

/// Fixed-size array that is allocated once; large ones ask for huge pages.
template <class T>
class Array {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Array() = default;
    explicit Array(Index size) : data_(allocate(size)), size_(size) { fill(T{}); }
    Array(const Array& other) : data_(allocate(other.size_)), size_(other.size_)
    {
        std::copy_n(other.data(), size_, data());
    }
    Array& operator=(const Array& other)
    {
        if (size_ != other.size_) *this = Array(other.size_);
        std::copy_n(other.data(), size_, data());
        return *this;
    }
    Array(Array&& other) noexcept : data_(std::move(other.data_)), size_(other.size_)
    {
        other.size_ = 0;
    }
    Array& operator=(Array&& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }

    Index size() const { return size_; }
    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    T& operator[](Index i) { return data_[static_cast<std::size_t>(i)]; }
    const T& operator[](Index i) const { return data_[static_cast<std::size_t>(i)]; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    void fill(T value) { std::fill(begin(), end(), value); }
    std::span<const T> span() const { return {data(), static_cast<std::size_t>(size_)}; }

private:
    struct Free {
        void* block = nullptr; ///< in which the values lie
        void operator()(T*) const { std::free(block); }
    };
    using Memory = std::unique_ptr<T[], Free>;

    static Memory allocate(Index size)
    {
        constexpr std::size_t huge = std::size_t{2} << 20;
        const std::size_t bytes = static_cast<std::size_t>(std::max<Index>(size, 1)) * sizeof(T);
        const bool large = bytes >= huge;
        const std::size_t alignment = large ? huge : 64, begin = large ? next_offset() : 0;
        const std::size_t end = begin + bytes;
        void* block = std::aligned_alloc(alignment, (end + alignment - 1) / alignment * alignment);
        if (!block) throw std::bad_alloc();
        if (large) madvise(block, end / huge * huge, MADV_HUGEPAGE);
        return Memory(reinterpret_cast<T*>(static_cast<char*>(block) + begin), Free{block});
    }

    /// Where in its first page a large array begins: each elsewhere, since arrays that are
    /// traversed together would else compete for the same lines of the caches.
    static std::size_t next_offset()
    {
        static std::atomic<std::size_t> count = 0;
        return count++ % 16 * (4 * 4096 + 5 * 64);
    }

    Memory data_;
    Index size_ = 0;
};

} // namespace starling
