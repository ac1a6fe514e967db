// SPDX-License-Identifier: MIT
//@ before /// Must be initialized with swDefaultWorldDef().
/// Made up for tests: how wet a wall in the water would be.
/// Must be initialized with swDefaultWetnessDef().
typedef struct swWetnessDef
{
    /// Wetness of a wall that the water covers by a metre. Range [0, 10]. Default 2.
    float soak;

    /// Dries as exp(-dryRate t), per second. Range [0.01, 10]. Default 0.5.
    float dryRate;

    /// Set by swDefaultWetnessDef().
    int internalValue;
} swWetnessDef;

SW_API swWetnessDef swDefaultWetnessDef(void);

//@ before /// Default SW_ISA_BEST: the widest that this machine has.
swWetnessDef wetness;
