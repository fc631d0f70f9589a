// How the board of a class is built: one script and one sheet of styles, which the front of the class serves.
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig } from 'vite'

export default defineConfig({
  plugins: [svelte()],
  base: './',
  build: {
    outDir: '../src/onika/web/static/board',
    emptyOutDir: true,
    target: 'es2022',
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: 1024,
    rollupOptions: {
      input: 'src/board/main.ts',
      output: { format: 'es', codeSplitting: false, entryFileNames: 'board.js', assetFileNames: 'board[extname]' },
    },
  },
})
