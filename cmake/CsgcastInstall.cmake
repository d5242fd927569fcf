# The installed package: libraries, headers, CMake config.
