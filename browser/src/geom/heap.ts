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
    let i = this.size++
    while (i > 0) {
      const parent = (i - 1) >> 1
      if (this.costs[parent] <= cost) break
      this.costs[i] = this.costs[parent]
      this.states[i] = this.states[parent]
      i = parent
    }
    this.costs[i] = cost
    this.states[i] = state
  }

  /** Take out the cheapest state; the heap must not be empty. */
  pop(): number {
    const first = this.states[0]
    const cost = this.costs[--this.size]
    const state = this.states[this.size]
    let i = 0
    for (;;) {
      let child = 2 * i + 1
      if (child >= this.size) break
      if (child + 1 < this.size && this.costs[child + 1] < this.costs[child]) child++
      if (this.costs[child] >= cost) break
      this.costs[i] = this.costs[child]
      this.states[i] = this.states[child]
      i = child
    }
    this.costs[i] = cost
    this.states[i] = state
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
