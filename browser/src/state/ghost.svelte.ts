// Where an arm would stand: shown beside the arm itself while somebody chooses values.

export interface Ghost {
  /** The arm, as `WORLD:NAME`. */
  device: string
  /** Of each joint, in rad or m. */
  joints: readonly number[]
  /** Whether it lies beyond a limit. */
  isBeyond: boolean
}

export const ghost: { current: Ghost | undefined } = $state({ current: undefined })
