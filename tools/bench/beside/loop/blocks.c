/* The arithmetic of the four blocks, as in blocks.py. */
#include <math.h>

enum { SIZE = 6 };

void path(double now, double *wanted) {
    for (int k = 0; k < SIZE; k++) wanted[k] = (0.2 + 0.2 * k) * sin((1.0 + k) * now);
}

void derivative(const double *new, double *old, double *rate) {
    for (int k = 0; k < SIZE; k++) {
        rate[k] = (new[k] - old[k]) * 1e3;
        old[k] = new[k];
    }
}

void torque(const double *wanted, const double *wanted_rate, const double *found, const double *found_rate, double *asked) {
    for (int k = 0; k < SIZE; k++) asked[k] = 400.0 * (wanted[k] - found[k]) + 40.0 * (wanted_rate[k] - found_rate[k]);
}

void moved(const double *pushed, double *position, double *rate) {
    for (int k = 0; k < SIZE; k++) {
        position[k] += 1e-3 * rate[k];
        rate[k] += 1e-3 * pushed[k];
    }
}
