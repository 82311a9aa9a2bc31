#pragma once

#include "priority/order.h"
#include "priority/steering.h"

#include <atomic>
#include <random>
#include <string>

namespace firstlight::priority {

/// The text of some order with a queue: one scheme, or a mixture of several in any form.
std::string random_order(std::mt19937& random);

/// Steers as a nervous user would, at most until `done`: other orders, boosts, pauses, pictures saved. Leaves the
/// picture neither paused nor stopped. Returns how often something was asked for that is wrong.
int steer_at_random(Steering& steering, std::mt19937& random, const std::atomic<bool>& done);

}  // namespace firstlight::priority
