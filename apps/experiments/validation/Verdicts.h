// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ObjectPolygons.h"
#include "TrueWorld.h"

namespace monoslam
{
/** Pairs of one or more runs, judged by truth. */
struct Verdicts
{
    long rightAccepted = 0;
    long wrongAccepted = 0;
    long rightRejected = 0;
    long wrongRejected = 0;

    void add(bool wrong, bool rejected);
    [[nodiscard]] long pairs() const;
    [[nodiscard]] double precision() const;  ///< share of the rejections that are wrong pairs
    [[nodiscard]] double recall() const;     ///< share of the wrong pairs that are rejected
};

/** Is a pair wrong? Told what the frame shows and when each landmark was born. */
class Judge
{
   public:
    virtual ~Judge() = default;
    [[nodiscard]] virtual bool isWrong(const Association& pair, long frame) = 0;
    /** Notes the births of one frame. */
    virtual void note(const std::vector<MapLandmark>& /*map*/) {}
};

/** Wrong: farther than 3 px from the true pixel of what the birth pixel shows. */
class DepthJudge : public Judge
{
   public:
    explicit DepthJudge(TrueWorld& world) : world_(world) {}
    [[nodiscard]] bool isWrong(const Association& pair, long frame) override;
    void note(const std::vector<MapLandmark>& map) override;

   private:
    TrueWorld& world_;
    std::map<LandmarkId, Eigen::Vector3d> points_;
};

/** Wrong: on the object once it moves. */
class MotionJudge : public Judge
{
   public:
    explicit MotionJudge(const ObjectPolygons& object) : object_(object) {}
    [[nodiscard]] bool isWrong(const Association& pair, long frame) override;

   private:
    const ObjectPolygons& object_;
};
}  // namespace monoslam
