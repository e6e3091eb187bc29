// SPDX-License-Identifier: GPL-3.0-or-later
// Calls the installed libraries.
#include "core/material/porous_bird.h"
#include "geometry/part_of_object.h"

#include <iostream>

int main()
{
  std::cout << birdstrike::porous_density(0.5) << ' ' << birdstrike::part_of_object("wing_left") << '\n';
}
