/** A binary heap of numbered states, the cheapest first; it keeps its memory from search to search. */

export class Heap {
  private costs = new Float64Array(1024)
  private states = new Int32Array(1024)
  private size = 0

  clear(): void {
    this.size = 0
  }

  get empty(): boolean {
    return this.size === 0
  }

  push(cost: number, state: number): void {
    if (this.size === this.states.length) this.grow()
    const { costs, states } = this
    let i = this.size++
    while (i > 0) {
      const parent = (i - 1) >> 1
      if (costs[parent] <= cost) break
      costs[i] = costs[parent]
      states[i] = states[parent]
      i = parent
    }
    costs[i] = cost
    states[i] = state
  }

  /** Take out the cheapest state; the heap must not be empty. */
  pop(): number {
    const { costs, states } = this
    const first = states[0]
    const size = --this.size
    const cost = costs[size]
    const state = states[size]
    let i = 0
    for (;;) {
      let child = 2 * i + 1
      if (child >= size) break
      if (child + 1 < size && costs[child + 1] < costs[child]) child++
      if (costs[child] >= cost) break
      costs[i] = costs[child]
      states[i] = states[child]
      i = child
    }
    costs[i] = cost
    states[i] = state
    return first
  }

  private grow(): void {
    const costs = new Float64Array(2 * this.costs.length)
    const states = new Int32Array(2 * this.states.length)
    costs.set(this.costs)
    states.set(this.states)
    this.costs = costs
    this.states = states
  }
}
