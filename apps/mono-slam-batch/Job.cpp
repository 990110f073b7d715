// SPDX-License-Identifier: BSD-3-Clause
#include "Job.h"

#include <mrpt/system/md5.h>

#include <algorithm>

namespace monoslam
{
using Words = std::vector<std::string>;

namespace
{
constexpr std::size_t kKeyDigits = 12;  // 48 bits: of a million jobs no two of one name meet

/** All seeds of one sequence, strategy and variant have this in common. */
Job jobOf(const Batch& batch, const Sequence& sequence, const std::string& strategy,
          const Variant& variant)
{
    Job job;
    job.sequence = sequence.name;
    job.strategy = strategy;
    job.variant = variant.name;
    job.origin = batch.fileName + ": [" + sequence.section + "] (" + sequence.name +
                 "), strategy " + strategy + ", [variant." + variant.name + "]";
    job.slam = {sequence.config, sequence.rawlog, "--set", "association.strategy=" + strategy};
    for (const Words* settings : {&sequence.settings, &variant.settings})
        for (const std::string& setting : *settings)
            job.slam.insert(job.slam.end(), {"--set", setting});
    if (sequence.outAndBack) job.evaluate = {"--out-and-back"};
    if (!sequence.truth.empty())
        job.evaluate = {"--groundtruth", sequence.truth, "--per-frame", sequence.alignment};
    if (!sequence.depth.empty())
        job.evaluate.insert(job.evaluate.end(), {"--depth", sequence.depth});
    if (!sequence.camera.empty())
        job.evaluate.insert(job.evaluate.end(), {"--camera", sequence.camera});
    return job;
}

std::string keyOf(const Job& job, const Sequence& sequence)
{
    std::string text = std::string(MONOSLAM_VERSION) + "\n" + sequence.fingerprint;
    const auto settings = job.slam.begin() + 2;  // the files' content counts, not their place
    for (auto word = settings; word != job.slam.end(); ++word) text += *word + "\n";
    text += std::to_string(job.seed);
    return mrpt::system::md5(text).substr(0, kKeyDigits);
}

bool isFor(const Variant& variant, const std::string& strategy)
{
    const Words& s = variant.strategies;
    return s.empty() || std::find(s.begin(), s.end(), strategy) != s.end();
}
}  // namespace

std::vector<Job> expandJobs(const Batch& batch)
{
    std::vector<Job> jobs;
    for (const Sequence& sequence : batch.sequences)
        for (const std::string& strategy : batch.strategies)
            for (const Variant& variant : batch.variants)
            {
                if (!isFor(variant, strategy)) continue;
                Job job = jobOf(batch, sequence, strategy, variant);
                for (const unsigned seed : batch.seeds)
                {
                    job.seed = seed;
                    job.folder = "jobs/" + sequence.name + "/" + strategy + "/" + variant.name +
                                 "/seed-" + std::to_string(seed) + "-" + keyOf(job, sequence);
                    jobs.push_back(job);
                }
            }
    return jobs;
}
}  // namespace monoslam
