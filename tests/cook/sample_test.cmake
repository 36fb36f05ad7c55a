coif_test(sample_test
  SOURCES sample_test.cpp
  LIBRARIES coif_sample)
