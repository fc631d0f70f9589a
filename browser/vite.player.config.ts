// How the player of shared files is built: one script and one sheet of styles, which `onika share` puts into each of them.
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig } from 'vite'

export default defineConfig({
  plugins: [svelte()],
  base: './',
  build: {
    outDir: '../src/onika/web/static/player',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 3072, // all of it stands in every file
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: {
      input: 'src/player/main.ts',
      output: { format: 'es', codeSplitting: false, entryFileNames: 'player.js', assetFileNames: 'player[extname]' },
    },
  },
})
