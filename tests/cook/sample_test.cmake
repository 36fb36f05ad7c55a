coif_test(sample_test
  SOURCES long_sample_test.cpp sample_meshes.cpp sample_test.cpp
  LIBRARIES coif_cook coif_import coif_sample)
