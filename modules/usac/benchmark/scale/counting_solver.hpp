// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_COUNTING_SOLVER_HPP
#define OPENCV_USACV20_BENCHMARK_COUNTING_SOLVER_HPP

#include <vector>
#include "opencv2/usac/components.hpp"

namespace benchmark {

/** Wraps a minimal solver and records its samples and the first models. It is not thread-safe.
together(), the number of samples that a run solves at once, keeps its default of 1, so that no
samples are solved that the run does not use. */
class CountingSolver : public cv::usacv20::MinimalSolver
{
public:
    typedef cv::usacv20::Model Model;

    explicit CountingSolver(const cv::Ptr<cv::usacv20::MinimalSolver>& solver_)
        : solver(solver_), computed(0)
    {}

    int sampleSize() const CV_OVERRIDE { return solver->sampleSize(); }

    int solve(const cv::usacv20::Correspondences& points, const int* sample,
              Model* models) const CV_OVERRIDE
    {
        samples.insert(samples.end(), sample, sample + sampleSize());
        const int count = solver->solve(points, sample, models);
        computed += count;
        for (int k = 0; k < count && found.size() < MOST_MODELS; ++k)
            found.push_back(models[k]);
        return count;
    }

    //! Number of samples solved so far.
    int solved() const { return (int)samples.size() / sampleSize(); }
    //! The point indices of the i-th solved sample.
    const int* sample(int i) const { return &samples[(size_t)i * sampleSize()]; }
    //! Number of models from all samples solved so far, including the samples of the polishing.
    int modelsOfAll() const { return computed; }
    //! The first models found, at most MOST_MODELS.
    const std::vector<Model>& models() const { return found; }

private:
    enum { MOST_MODELS = 500 };

    const cv::Ptr<cv::usacv20::MinimalSolver> solver;
    mutable int computed;
    mutable std::vector<int> samples;
    mutable std::vector<Model> found;
};

}  // namespace benchmark

#endif
