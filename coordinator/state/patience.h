// How long nobody is to be taken for lost because the coordinator itself stood still.
#ifndef TILEMEND_COORDINATOR_STATE_PATIENCE_H_
#define TILEMEND_COORDINATOR_STATE_PATIENCE_H_

#include "absl/time/time.h"

namespace tilemend {

// A process that is stopped, swapped out or waits for a disk hears nobody, and finds everybody silent when it goes on.
// So it looks at the clock at regular times, and after a gap it gives every worker a whole lease to call again.
class Patience {
 public:
  // `interval`: between two looks. `lease`: how long a worker may be silent.
  Patience(absl::Duration interval, absl::Duration lease) : gap_(interval + lease / 4), lease_(lease) {}

  // A look at the clock. Whether silent workers may be taken for lost now.
  bool IsOver(absl::Time now) {
    if (now - last_look_ > gap_) until_ = now + lease_;
    last_look_ = now;
    return now >= until_;
  }

 private:
  const absl::Duration gap_, lease_;
  absl::Time last_look_ = absl::InfinitePast();
  absl::Time until_ = absl::InfinitePast();
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_PATIENCE_H_
