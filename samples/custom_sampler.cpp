// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// A component of one's own: a sampler that spreads its samples over image 1 takes the place of the default one.

#include "tools.hpp"

namespace {

/** Draws the points of a sample from different cells of a grid over image 1, as long as enough of the cells hold points. A
model from points far apart extrapolates less, at the price that local structures are found later. Its samples count for the
criteria of termination (State::counts stays true): any point can be drawn. */
class SpreadSampler : public cv::usacv20::Sampler
{
public:
    void sample(const cv::usacv20::Context& context, cv::usacv20::State& state, int* sample) CV_OVERRIDE
    {
        const int wanted = context.components.minimalSolver->sampleSize();
        if (cells.empty())
            assign(context.points);
        if ((int)cells.size() < wanted)
        {
            state.rng.distinct(context.points.size, wanted, sample);
            return;
        }
        int chosen[cv::usacv20::MAX_SAMPLE_SIZE];
        state.rng.distinct((int)cells.size(), wanted, chosen);
        for (int k = 0; k < wanted; ++k)
        {
            const std::vector<int>& cell = cells[chosen[k]];
            sample[k] = cell[state.rng.uniform((int)cell.size())];
        }
    }

private:
    enum { DIVISIONS = 4 };

    static int division(float value, float low, float high)
    {
        const float cell = high > low ? (value - low) * DIVISIONS / (high - low) : 0;
        return std::max(0, std::min((int)cell, DIVISIONS - 1));
    }

    //! Sorts the points into cells and forgets the empty ones.
    void assign(const cv::usacv20::Correspondences& p)
    {
        std::vector<std::vector<int> > all(DIVISIONS * DIVISIONS);
        for (int i = 0; i < p.size; ++i)
            all[division(p.y1[i], p.lower[1], p.upper[1]) * DIVISIONS + division(p.x1[i], p.lower[0], p.upper[0])].push_back(i);
        for (size_t c = 0; c < all.size(); ++c)
            if (!all[c].empty())
                cells.push_back(all[c]);
    }

    std::vector<std::vector<int> > cells;
};

//! Runs the estimator with the components of `params`, or with another sampler among them.
void run(const char* name, const tools::Matches& matches, const cv::usacv20::Params& params,
         const cv::Ptr<cv::usacv20::Sampler>& sampler)
{
    using namespace cv::usacv20;
    cv::Ptr<Usac> usac = Usac::create(HOMOGRAPHY, matches.points1, matches.points2, params);
    if (sampler)
        usac->components().sampler = sampler;
    cv::Mat mask;
    Report report;
    const cv::Mat H = usac->run(mask, &report);
    std::cout << cv::format("%-13s  %s\n", name, report.describe().c_str());
    CV_Assert(!H.empty());
}

int sample(const cv::CommandLineParser& parser)
{
    const cv::Mat image1 = tools::readImage(parser.get<std::string>("@image1"));
    const cv::Mat image2 = tools::readImage(parser.get<std::string>("@image2"));
    const tools::Matches matches = tools::match(image1, image2, parser);
    cv::usacv20::Params params;
    params.threshold = parser.get<double>("threshold");
    params.confidence = parser.get<double>("confidence");
    params.maxIterations = parser.get<int>("iterations");
    std::cout << matches.points1.size() << " matches\n";
    run("P-NAPSAC", matches, params, cv::Ptr<cv::usacv20::Sampler>());
    run("SpreadSampler", matches, params, cv::makePtr<SpreadSampler>());
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string keys =
        "{help h usage ? |           | print this help}"
        "{@image1        | graf1.png | image 1, a path or the name of one of OpenCV's sample images}"
        "{@image2        | graf3.png | image 2}"
        "{ratio          | 0.8       | largest ratio of the distances of the best and the second best match}"
        "{features       | 8000      | largest number of features of an image}"
        "{confidence     | 0.99      | probability that the model is the best one}"
        "{threshold      | 2         | inlier threshold in pixels}"
        "{iterations     | 10000     | largest number of samples}";
    return tools::runSample(argc, argv, keys, "Homography of two images with a sampler of one's own.", sample);
}
