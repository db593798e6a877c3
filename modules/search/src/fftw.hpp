// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  FFTW in the two precisions under one name, with owners. Plans are estimated and not measured, so
/// that the same numbers come out on every run.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>

#include <fftw3.h>

namespace wm3d::search {

/// FFTW's planner is the one part of it that threads must not enter together.
inline std::mutex& planner() {
    static std::mutex mutex;
    return mutex;
}

template<typename Real>
struct Fftw;

template<>
struct Fftw<double> {
    using Plan = fftw_plan;
    using Complex = fftw_complex;
    static Plan real_to_complex(int n, double* in, Complex* out) {
        return fftw_plan_dft_r2c_1d(n, in, out, FFTW_ESTIMATE);
    }
    static Plan complex_to_complex(int rows, int columns, Complex* in, Complex* out) {
        return fftw_plan_dft_2d(rows, columns, in, out, FFTW_BACKWARD, FFTW_ESTIMATE);
    }
    static void run(Plan plan, double* in, Complex* out) { fftw_execute_dft_r2c(plan, in, out); }
    static void run(Plan plan, Complex* in, Complex* out) { fftw_execute_dft(plan, in, out); }
    static void destroy(Plan plan) { fftw_destroy_plan(plan); }
};

template<>
struct Fftw<float> {
    using Plan = fftwf_plan;
    using Complex = fftwf_complex;
    static Plan complex_to_complex(int rows, int columns, Complex* in, Complex* out) {
        return fftwf_plan_dft_2d(rows, columns, in, out, FFTW_BACKWARD, FFTW_ESTIMATE);
    }
    static void run(Plan plan, Complex* in, Complex* out) { fftwf_execute_dft(plan, in, out); }
    static void destroy(Plan plan) { fftwf_destroy_plan(plan); }
};

/// Memory that FFTW's vector instructions may be used on; the contents start undefined.
template<typename T>
class FftwArray {
public:
    explicit FftwArray(std::size_t size) : data_(static_cast<T*>(fftw_malloc(size * sizeof(T)))) {
        if (!data_)
            throw std::bad_alloc();
    }
    T* get() const { return data_.get(); }
    T& operator[](std::size_t i) const { return data_.get()[i]; }

private:
    struct Free {
        void operator()(T* data) const { fftw_free(data); }
    };
    std::unique_ptr<T, Free> data_;
};

/// A plan that any array from FftwArray may be put through, on any thread.
template<typename Real>
class FftwPlan {
public:
    explicit FftwPlan(typename Fftw<Real>::Plan plan) : plan_(plan) {}
    FftwPlan(const FftwPlan&) = delete;
    FftwPlan& operator=(const FftwPlan&) = delete;
    ~FftwPlan() {
        const std::lock_guard lock(planner());
        Fftw<Real>::destroy(plan_);
    }
    template<typename In, typename Out>
    void operator()(In* in, Out* out) const {
        Fftw<Real>::run(plan_, in, out);
    }

private:
    typename Fftw<Real>::Plan plan_;
};

} // namespace wm3d::search
