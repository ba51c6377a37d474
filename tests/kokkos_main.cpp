// Every test executable: Kokkos around GoogleTest.
#include <Kokkos_Core.hpp>

#include <gmock/gmock.h>

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
