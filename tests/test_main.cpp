// main() of the test programs: those whose tests ask for processes of their own are run again for that.

#include "platform/job.h"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  coif::platform::run_named_job(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
