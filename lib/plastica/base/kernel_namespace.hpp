#pragma once

/// Where a kernel's names live. A source file that is compiled for one instruction set defines
/// PLASTICA_KERNEL_ISA as that set's name before it includes anything: what kernels consist of then
/// lies in an inline namespace of that name, so that no other file can be handed its code by the
/// linker (an inline function of two files is kept once, whoever's flags it was compiled with).
#ifdef PLASTICA_KERNEL_ISA
#define PLASTICA_KERNELS_BEGIN inline namespace PLASTICA_KERNEL_ISA {
#define PLASTICA_KERNELS_END }
#else
#define PLASTICA_KERNELS_BEGIN
#define PLASTICA_KERNELS_END
#endif
