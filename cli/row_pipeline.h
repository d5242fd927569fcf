// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "cli/number_rows.h"
#include "cli/output.h"

namespace csgcast::cli {

/// Where rows come from: fills in the next one, false at the end.
using RowSource = std::function<bool(NumberRow&)>;

/// Answers rows on several threads and writes the answers in the rows' order. Only a few batches are in memory at a
/// time, however many rows there are.
///
/// `make_worker()` makes what answers, one for each thread; `worker(row, text)` appends the answer to a text. What any
/// of them throws ends the whole and is thrown on.
template <class MakeWorker>
void answer_rows(const RowSource& source, Output& output, int threads, MakeWorker&& make_worker) {
  constexpr std::size_t batch_rows = 128;
  struct Batch {
    std::vector<NumberRow> rows;
    std::string text;
  };
  using BatchPointer = std::shared_ptr<Batch>;
  tbb::enumerable_thread_specific<std::invoke_result_t<MakeWorker&>> workers(make_worker);

  const auto read = [&](tbb::flow_control& control) -> BatchPointer {
    auto batch = std::make_shared<Batch>();
    NumberRow row;
    while (batch->rows.size() < batch_rows && source(row)) batch->rows.push_back(row);
    if (batch->rows.empty()) control.stop();
    return batch;
  };
  const auto answer = [&](const BatchPointer& batch) {
    auto& worker = workers.local();
    for (const NumberRow& row : batch->rows) worker(row, batch->text);
    return batch;
  };
  const auto write = [&](const BatchPointer& batch) { output.write(batch->text); };

  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_pipeline(static_cast<std::size_t>(2 * threads),
                           tbb::make_filter<void, BatchPointer>(tbb::filter_mode::serial_in_order, read) &
                               tbb::make_filter<BatchPointer, BatchPointer>(tbb::filter_mode::parallel, answer) &
                               tbb::make_filter<BatchPointer, void>(tbb::filter_mode::serial_in_order, write));
  });
}

}  // namespace csgcast::cli
