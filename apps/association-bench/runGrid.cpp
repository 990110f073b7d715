// SPDX-License-Identifier: BSD-3-Clause
#include "runGrid.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <thread>

namespace monoslam
{
namespace
{
/** Solved by one strategy before the next one begins, so that caches are warm, and that what a
 *  forked child costs its parent in page faults falls on few of the others' problems. */
constexpr int kBatch = 10;

std::vector<Cell> cellsOf(const GridAxes& grid)
{
    std::vector<Cell> cells;
    for (const int m : grid.landmarks)
        for (const int c : grid.candidates)
            for (const int r : grid.absent)
                if (2 * r <= m) cells.push_back({{m, c, r}, {}});
    if (cells.empty())
        throw std::invalid_argument("--absent: more than half of the landmarks in every cell");
    return cells;
}

void solveCell(const Arguments& arguments, const Strategies& strategies, Cell& cell)
{
    const auto made = strategies.makeFor(cell.shape.landmarks, cell.shape.candidates);
    cell.figures.resize(made.size());
    const int problems = arguments.grid.problems;
    for (int first = 0; first < problems; first += kBatch)
    {
        std::vector<RecordedFrame> frames;
        for (int i = first; i < std::min(first + kBatch, problems); ++i)
            frames.push_back(drawProblem(cell.shape, arguments.seed + static_cast<unsigned>(i)));
        for (std::size_t s = 0; s < made.size(); ++s)
            for (const RecordedFrame& frame : frames)
                cell.figures[s].add(solveProblem(*made[s].associator, frame, arguments.seed));
    }
}

/** What the workers share. */
struct Work
{
    std::vector<Cell> cells;
    std::vector<std::size_t> order;  ///< the large ones first, which would else be waited for
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
};

void workOn(Work& work, const Arguments& arguments, const Strategies& strategies,
            std::exception_ptr& error)
{
    try
    {
        for (std::size_t i = work.next++; i < work.order.size(); i = work.next++)
        {
            Cell& cell = work.cells[work.order[i]];
            solveCell(arguments, strategies, cell);
            std::fprintf(stderr, "%zu of %zu cells: m = %d, candidates %d, absent %d\n",
                         ++work.done, work.cells.size(), cell.shape.landmarks,
                         cell.shape.candidates, cell.shape.absent);
        }
    }
    catch (...)
    {
        error = std::current_exception();
        work.next = work.order.size();
    }
}
}  // namespace

std::vector<Cell> runGrid(const Arguments& arguments, const Strategies& strategies)
{
    Work work;
    work.cells = cellsOf(arguments.grid);
    for (std::size_t i = 0; i < work.cells.size(); ++i) work.order.push_back(i);
    std::stable_sort(work.order.begin(), work.order.end(),
                     [&](std::size_t a, std::size_t b)
                     { return work.cells[a].shape.landmarks > work.cells[b].shape.landmarks; });
    std::vector<std::exception_ptr> errors(static_cast<std::size_t>(arguments.workers));
    std::vector<std::thread> workers;
    for (std::exception_ptr& error : errors)
        workers.emplace_back(workOn, std::ref(work), std::cref(arguments), std::cref(strategies),
                             std::ref(error));
    for (std::thread& worker : workers) worker.join();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    return std::move(work.cells);
}
}  // namespace monoslam
