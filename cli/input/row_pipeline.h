// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_pipeline.h>

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "cli/input/number_rows.h"
#include "cli/output/output.h"
#include "raycast/packets/threads.h"

namespace csgcast::cli {

/// Where rows come from: fills in the next one, false at the end.
using RowSource = std::function<bool(NumberRow&)>;

/// Answers rows on the present threads (raycast/packets/threads.h) and writes the answers in the rows' order. Only a
/// few batches are in memory at a time, however many rows there are.
///
/// `make_worker()` makes what answers, one for each thread; `worker(row, text)` appends the answer to a text. What any
/// of them throws ends the whole and is thrown on.
template <class MakeWorker>
void answer_rows(const RowSource& source, Output& output, MakeWorker&& make_worker) {
  constexpr std::size_t batch_rows = 128;
  struct Batch {
    std::vector<NumberRow> rows;
    std::string text;
  };
  // At most as many batches are under way as the ring has places, and they are written in order: the next place is
  // always free. The ring owns them because a pipeline that ends early forgets what is in it.
  std::vector<Batch> ring(static_cast<std::size_t>(2 * thread_count()));
  std::size_t batch_count = 0;
  tbb::enumerable_thread_specific<std::invoke_result_t<MakeWorker&>> workers(make_worker);

  const auto read = [&](tbb::flow_control& control) -> Batch* {
    Batch& batch = ring[batch_count++ % ring.size()];
    batch.rows.clear();
    batch.text.clear();
    NumberRow row;
    while (batch.rows.size() < batch_rows && source(row)) batch.rows.push_back(row);
    if (batch.rows.empty()) control.stop();
    return &batch;
  };
  const auto answer = [&](Batch* batch) {
    auto& worker = workers.local();
    for (const NumberRow& row : batch->rows) worker(row, batch->text);
    return batch;
  };
  const auto write = [&](const Batch* batch) { output.write(batch->text); };

  tbb::parallel_pipeline(ring.size(), tbb::make_filter<void, Batch*>(tbb::filter_mode::serial_in_order, read) &
                                          tbb::make_filter<Batch*, Batch*>(tbb::filter_mode::parallel, answer) &
                                          tbb::make_filter<Batch*, void>(tbb::filter_mode::serial_in_order, write));
}

}  // namespace csgcast::cli
