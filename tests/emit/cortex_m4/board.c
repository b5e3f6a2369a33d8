/* A Cortex-M4F without an operating system: starts, calls every function at every state, and says the results and the
   stack that they took, in hexadecimal, to the host by semihosting. The states are in states.h, which the test writes. */
#include <stdint.h>
#include <string.h>

#include "states.h"

int call(int f, const float* const* a, float t, const float* p, const float* w, float* const* r);

extern uint32_t stack_bottom, stack_top;
void reset(void);

__attribute__((section(".vectors"), used)) static const struct {
  const uint32_t* stack;
  void (*reset)(void);
} vectors = {&stack_top, reset};

static int host(int operation, const void* argument) {
  register int r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

static void say(uint32_t number, char end) {
  char text[10];
  for (int i = 0; i < 8; ++i) text[i] = "0123456789abcdef"[(number >> (28 - 4 * i)) & 15u];
  text[8] = end;
  text[9] = 0;
  host(0x04, text); /* SYS_WRITE0 */
}

#define UNTOUCHED 0xa5c3965au

static float results[RESULTS];

/* Bytes of stack that a call takes below this function; nothing else runs. */
__attribute__((noinline)) static uint32_t stack_of(int function, const float* state) {
  const float* a[4] = {0, 0, 0, 0};
  float* r[6];
  uint32_t* here;
  if (function >= 0) {
    for (int i = 0; i < 4; ++i) a[i] = state + argument_places[function][i];
    for (int i = 0; i < 6; ++i) r[i] = results + result_places[function][i];
  }
  __asm__ volatile("mov %0, sp" : "=r"(here));
  for (uint32_t* at = &stack_bottom; at < here; ++at) *at = UNTOUCHED;
  const int status = call(function, a, state[TIME], state + PARAMETERS, state + WRENCHES, r);
  const uint32_t* lowest = &stack_bottom;
  while (lowest < here && *lowest == UNTOUCHED) ++lowest;
  if (function >= 0 && status != 0) say(0xffffffffu, '!');
  return (uint32_t)((const char*)here - (const char*)lowest);
}

void reset(void) {
  *(volatile uint32_t*)0xe000ed88u |= 0xfu << 20; /* the floating point unit */
  __asm__ volatile("dsb\n\tisb");
  for (int s = 0; s < STATES; ++s)
    for (int f = 0; f < FUNCTIONS; ++f) {
      float state[STATE];
      memcpy(state, states[s], sizeof state);
      const uint32_t nothing = stack_of(-1, state), taken = stack_of(f, state);
      say(taken > nothing ? taken - nothing : 0, ':');
      for (int i = 0; i < result_counts[f]; ++i) {
        uint32_t bits;
        memcpy(&bits, &results[i], sizeof bits);
        say(bits, ' ');
      }
      host(0x04, "\n");
    }
  host(0x18, (const void*)0x20026); /* SYS_EXIT: finished */
  for (;;) {
  }
}
